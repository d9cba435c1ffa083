// Blocks are renumbered internally for memory locality. Only the numbers change.
#include "model/numbering.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

#include "tools/fields.hpp"

namespace blocks {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Random numbers that are the same on every machine.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  double number() { return static_cast<double>(random_()) * 0x1p-31 - 1.0; }
  void shuffle(std::vector<int>& list) {
    for (int i = static_cast<int>(list.size()); i > 1; --i)
      std::swap(list[i - 1], list[below(i)]);
  }

 private:
  std::mt19937 random_;
};

/// Returns 0 to n - 1 in order.
std::vector<int> counted(int n) {
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Returns the boxes of a grid in this order; box k of a row-wise count is in row
/// k / width.
Blocks grid(int width, const std::vector<int>& order) {
  std::vector<NewBlock> boxes;
  for (const int k : order) {
    const double x = k % width, y = 0.5 * (k / width);
    boxes.push_back({{{x, y}, {x, y + 0.5}, {x + 1, y + 0.5}, {x + 1, y}}, 1, 1.0});
  }
  Blocks blocks;
  blocks.append(boxes);
  return blocks;
}

TEST(BetterOrder, IsGivenToLargeModelsNumberedAtRandom) {
  constexpr int width = 100, rows = 50, n = width * rows;
  std::vector<int> along_rows = counted(n), columns, random = along_rows;
  for (int k = 0; k < n; ++k)
    columns.push_back(k % rows * width + k / rows);
  Dice(1).shuffle(random);
  EXPECT_THAT(order_if_worthwhile(grid(width, along_rows)), IsEmpty());
  EXPECT_THAT(order_if_worthwhile(grid(width, columns)), IsEmpty());
  EXPECT_THAT(order_if_worthwhile(grid(width, random)), SizeIs(n));
  EXPECT_THAT(order_if_worthwhile(grid(width, random), n + 1), IsEmpty());
  EXPECT_THAT(order_if_worthwhile({}, 0), IsEmpty());
}

// The wall is wider than high, so strips are one or two columns of boxes, numbered from
// below.
TEST(StripOrder, RunsAlongTheShorterSideOfTheModel) {
  std::vector<int> random = counted(300);
  Dice(2).shuffle(random);
  const Blocks wall = grid(30, random);
  const std::vector<int> order = strip_order(wall);
  ASSERT_THAT(std::set<int>(order.begin(), order.end()), SizeIs(300));
  int down = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
    down += wall.centroid(1, order[i]) < wall.centroid(1, order[i - 1]);
  EXPECT_GE(down, 14);
  EXPECT_LE(down, 29);
}

/// Returns random polygons with contacts, planes and loads between any of them.
Model random_model(Dice& dice) {
  Model model;
  const int n = 2 + dice.below(40);
  for (int b = 0; b < n; ++b) {
    const int corners = 3 + dice.below(5);
    const double height = dice.number();
    geometry::Polygon outline;
    for (int c = 0; c < corners; ++c) {
      const double turn = -2.0 * std::numbers::pi * c / corners;
      outline.emplace_back(9 * b + std::cos(turn), height + std::sin(turn));
    }
    model.blocks.append(
        {{outline, 1 + dice.below(3), 2.0,
          dice.below(4) == 0 ? Fixity::by_user : Fixity::free, dice.below(3)}});
  }
  Blocks& blocks = model.blocks;
  for (auto* column : {&blocks.velocity, &blocks.force})
    for (double& value : column->reshaped())
      value = dice.number();
  for (auto* column : {&blocks.applied, &blocks.stress, &blocks.strain_rate})
    for (double& value : column->reshaped())
      value = dice.number();
  for (auto* column : {&blocks.angle, &blocks.spin, &blocks.moment})
    for (double& value : *column)
      value = dice.number();

  std::set<std::tuple<int, int, int, int>> places;
  for (int i = dice.below(500); i > 0; --i) {
    const int c = dice.below(blocks.corners()), e = dice.below(blocks.corners());
    const auto [low, high] =
        std::minmax({blocks.corner_block[c], blocks.corner_block[e]});
    if (low != high)
      places.emplace(low, high, c, e);
  }
  for (const auto& [low, high, corner, edge] : places)
    model.contacts.push_back(
        {corner, edge, dice.number(), dice.number(), dice.number()});
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    model.law_states.push_back({dice.below(3), dice.number(), dice.number()});
  std::set<std::pair<int, int>> on_planes;
  for (int k = dice.below(20); k > 0; --k)
    on_planes.emplace(dice.below(2), dice.below(blocks.corners()));
  for (const auto& [plane, corner] : on_planes)
    model.plane_contacts.push_back({plane, corner, dice.below(2) == 1, dice.number(),
                                    dice.number(), dice.number(), dice.number()});
  for (int k = 0; k < 5; ++k) {
    model.loads.pressures.push_back({dice.below(n), 0, dice.number()});
    model.loads.forces.push_back({dice.below(n), {dice.number(), 0}});
  }
  for (int b = 0; b < n; ++b)
    if (blocks.fixity[b] == Fixity::by_user)
      model.drives.push_back({b, {dice.number(), dice.number()}, dice.number()});
  return model;
}

Model renumbered(Model model, const Numbering& by) {
  by.renumber(model);
  return model;
}

/// Returns the coordinates of corner and edge of each contact, and its forces.
std::multiset<std::vector<double>> acting(const Model& model) {
  std::multiset<std::vector<double>> all;
  for (const Contact& contact : model.contacts) {
    const Vec2 corner = model.blocks.corner.col(contact.corner);
    const Vec2 edge = model.blocks.corner.col(contact.edge);
    all.insert({corner.x(), corner.y(), edge.x(), edge.y(), contact.normal_elastic,
                contact.shear_elastic, contact.normal_force});
  }
  return all;
}

bool is_in_order(const Model& model) {
  return std::is_sorted(model.contacts.begin(), model.contacts.end(),
                        [&](const Contact& l, const Contact& r) {
                          return sort_key(model.blocks, l) < sort_key(model.blocks, r);
                        });
}

/// A random model, the same model renumbered at random, and the numbering.
struct Renumbered {
  explicit Renumbered(unsigned seed)
      : dice(seed), model(random_model(dice)), order(shuffled(dice, model)),
        numbering(model.blocks, order), other(renumbered(model, numbering)) {}
  static std::vector<int> shuffled(Dice& dice, const Model& model) {
    std::vector<int> order = counted(model.blocks.size());
    dice.shuffle(order);
    return order;
  }
  Dice dice;
  Model model;
  std::vector<int> order;
  Numbering numbering;
  Model other;
};

constexpr unsigned models = 200;

TEST(Numbering, IsUndoneByItsReverse) {
  for (unsigned seed = 1; seed <= models; ++seed) {
    const Renumbered r(seed);
    ASSERT_EQ(samples::fields(renumbered(r.other, r.numbering.reverse())),
              samples::fields(r.model))
        << seed;
  }
}

TEST(Numbering, KeepsContactsSortedByTheNewNumbers) {
  for (unsigned seed = 1; seed <= models; ++seed)
    ASSERT_TRUE(is_in_order(Renumbered(seed).other)) << seed;
}

TEST(Numbering, KeepsContactsAndTheirForces) {
  for (unsigned seed = 1; seed <= models; ++seed) {
    const Renumbered r(seed);
    ASSERT_EQ(acting(r.other), acting(r.model)) << seed;
  }
}

TEST(Numbering, KeepsStatesWithTheirContactsAndDrivesWithTheirBlocks) {
  for (unsigned seed = 1; seed <= models; ++seed) {
    Renumbered r(seed);
    for (std::size_t k = 0; k < r.model.contacts.size(); ++k)
      r.model.law_states[k].slip = r.model.contacts[k].normal_elastic;
    const Model other = renumbered(r.model, r.numbering);
    for (std::size_t k = 0; k < other.contacts.size(); ++k)
      ASSERT_EQ(other.law_states[k].slip, other.contacts[k].normal_elastic);
    ASSERT_EQ(other.drives.size(), r.model.drives.size());
    for (std::size_t k = 0; k < other.drives.size(); ++k) {
      ASSERT_EQ(other.blocks.fixity[other.drives[k].block], Fixity::by_user);
      ASSERT_TRUE(k == 0 || other.drives[k - 1].block < other.drives[k].block);
    }
  }
}

TEST(Numbering, PutsBlocksInTheGivenOrder) {
  for (unsigned seed = 1; seed <= models; ++seed) {
    const Renumbered r(seed);
    for (int b = 0; b < r.model.blocks.size(); ++b)
      ASSERT_EQ(r.other.blocks.outline(b), r.model.blocks.outline(r.order[b])) << seed;
  }
}

}  // namespace
}  // namespace blocks
