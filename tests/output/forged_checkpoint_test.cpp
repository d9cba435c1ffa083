// Checkpoints with one forged field and a valid checksum. Values that no run writes are
// refused. A model with other values is refused or makes a step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <limits>

#include "dynamics/stepper.hpp"
#include "output/checkpoint/checkpoint.hpp"
#include "output/checkpoint/checkpoint_validation.hpp"
#include "output/checkpoint/model_archive.hpp"
#include "sample_model.hpp"
#include "sealed.hpp"

namespace blocks::output {
namespace {

using samples::contents;
using samples::file_error;
using samples::overwrite;
using samples::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Returns a model with an entry in every list.
Model full_model() {
  Model model = samples::two_blocks();
  model.contacts.push_back({7, 1});
  model.settings.gravity_ramp = {{1, 2}, 0.0, 4.0};
  model.settings.local_damping = 0.5;
  model.settings.kinetic_damping = true;
  model.settings.mass_scaling = true;
  model.blocks.scale = Eigen::Vector2d(2.0, 0.5);
  model.last_kinetic_energy = 2.0;
  model.settings.merge_ratio = *geometry::Decimal::parse("0.2");
  model.loads.function = {{0, 1}, {1, 0}};
  model.loads.pressures = {{1, 2, 5, 6, 0.5}};
  model.loads.forces = {{1, {3, 4}, 0.25}};
  model.loads.quiet_sides = {{1, 2, 30, 20, {1, 2}, {3, 4}}};
  model.output = {0.5, 1.0};
  model.plots = {0.25, 0.75};
  model.plot_times = {0.125, 0.5};
  model.plot_steps = {10, 0};
  model.history = {0.125, {"ke", "y:2"}};
  model.output_blocks = {0, 1};
  model.fixed_in_ground = {0};
  model.order = {1, 0};
  model.exits = {{0, 0.004}};
  model.merges = {{1, 2, 3, 0.125, 0.2}};
  model.layers = {{1, 0, 2, 2, 1, 6, 0, 0, 0}};
  model.solves = {{12, 1e-5, 2e-5, 100, 0.5, false, 3.0, 1, 1e-3, 0.5, 1}};
  model.settings.crack_rules[3] = {1e6, 0.25, 5e5, 7};
  model.settings.materials[3].damping = 0.125;
  model.cracks = {samples::crack_of_block_2()};
  model.cracks[0].parent = 0, model.cracks[0].child = 1;
  model.crack_refusals = {{0, CrackRefusal::small}, {1, CrackRefusal::full}};
  samples::add_laws(model);
  model.loads.water = {{100.0, {0, 1}, {0, 4}, {-9, -9}, {1, 2}, 0.0, 0.5, false},
                       {{.joint = 0,
                         .a = {0, 0},
                         .b = {2, 0},
                         .p1 = 5.0,
                         .p2 = 1.0,
                         .reach = 0.5,
                         .begin = 0.0,
                         .duration = 0.25}}};
  model.energy.kept = true;
  model.kept.blocks = 2, model.kept.longest_path = 0.5;
  model.kept.poses = {{.block = 0}, {.block = 1}};
  model.kept.contacts = {{.corner = 4, .edge = 1, .tested = true}};
  model.kept.pairs = {{.low = 0,
                       .high = 1,
                       .validity = {.distance = 1e-3, .until = 2e-3, .pose = {}},
                       .contacts = 1,
                       .poses = 2,
                       .depths = 1}};
  model.kept.depths = {
      {.own_block = 0, .other_block = 1, .side = 2, .min = -1e-9, .max = 1e-6}};
  model.kept.pieces = {1};
  model.energy.sums.assign(energy_entries, 0.25);
  model.energy.errors.assign(energy_entries, 0.0);
  return model;
}

/// Counts the values of a model that can be forged, and forges the wanted one.
class Forger {
 public:
  enum class How { never, perhaps, longer, shorter };
  Forger(How how, long wanted) : how_(how), wanted_(wanted) {}
  std::string forged;  ///< name of the forged field, empty if there are no more

  template <class T> void operator()(const Field& field, T& value) {
    forge(field.name, value);
  }
  template <class R, class Visit>
  void records(const Field& field, std::vector<R>& list, Visit&& visit) {
    auto member = [&](const Field& at, auto& value) {
      forge(std::string(field.name) + "/" + at.name, value);
    };
    for (R& record : list)
      visit(member, record);
  }
  template <class Map, class Visit>
  void materials(const Field& field, Map& map, Visit&& visit) {
    auto member = [&](const Field& at, auto& value) {
      forge(std::string(field.name) + "/" + at.name, value);
    };
    Map changed;
    for (const auto& [key, value] : map) {
      auto number = key;
      auto material = value;
      visit(member, number, material);
      changed.emplace(number, material);
    }
    map = changed;
  }

 private:
  template <Number T> void forge(const std::string& name, T& value) {
    // A joint may open without limit.
    const bool may_be_infinite = name == "settings/joint_laws/dilation_limit";
    if (!std::is_same_v<T, bool>)
      for (const T worse : forgeries(value))
        if (!(may_be_infinite && worse > std::numeric_limits<T>::max()) && now(name))
          value = worse;
  }
  void forge(const std::string&, std::string&) {}
  void forge(const std::string&, geometry::Decimal&) {}
  template <class T> void forge(const std::string&, std::optional<T>&) {}
  template <class T> void forge(const std::string& name, std::vector<T>& column) {
    for (auto&& place : column) {
      T value = place;
      forge(name, value);
      place = value;
    }
    // These lists may have any length, or are empty because all blocks are convex.
    if (name == "output/blocks" || name == "blocks/cuts" ||
        name == "history/quantities" || name == "plots/times" ||
        name == "kept/pieces" || name == "fixed_in_ground")
      return;
    if (how_ == How::longer && now(name))
      column.push_back(column.back());
    if (how_ == How::shorter && now(name))
      column.pop_back();
  }
  template <class D> void forge(const std::string& name, Eigen::PlainObjectBase<D>& m) {
    for (Eigen::Index i = 0; i < m.size(); ++i)
      forge(name, m.data()[i]);
    if constexpr (D::SizeAtCompileTime == Eigen::Dynamic) {
      const Eigen::Index change = how_ == How::longer ? 1 : -1;
      if ((how_ == How::longer || how_ == How::shorter) && now(name)) {
        if constexpr (D::ColsAtCompileTime == 1)
          m.conservativeResize(m.size() + change);
        else
          m.conservativeResize(m.rows(), m.cols() + change);
      }
    }
  }
  bool now(const std::string& name) {
    if (next_++ != wanted_)
      return false;
    forged = name;
    return true;
  }
  template <class T> std::vector<T> forgeries(T value) const {
    if (how_ == How::longer || how_ == How::shorter)
      return {};
    const bool never = how_ == How::never;
    if constexpr (std::is_same_v<T, double>) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      return never ? std::vector<T>{std::nan(""), infinity, -infinity}
                   : std::vector<T>{0.0, -1.0, 1e300, -value};
    } else if constexpr (std::is_enum_v<T>) {
      return never ? std::vector<T>{T{-1}, T{5}} : std::vector<T>{T{0}, T{1}, T{2}};
    } else if constexpr (std::is_same_v<T, std::uint64_t>) {
      return {};  // All seeds are valid.
    } else {
      constexpr T min = std::numeric_limits<T>::min(),
                  max = std::numeric_limits<T>::max();
      return never ? std::vector<T>{min}
                   : std::vector<T>{max, static_cast<T>(-1), T{0},
                                    static_cast<T>(value + 1)};
    }
  }

  How how_;
  long wanted_, next_ = 0;
};

/// Forges one value after the other and returns their number. Calls judge(name, reason)
/// with the reason of each refusal, which is empty if the model made a step.
template <class Judge> long forge_all(Forger::How how, Judge&& judge) {
  for (long wanted = 0;; ++wanted) {
    Model model = full_model();
    Forger forger(how, wanted);
    visit_model(model, forger);
    if (forger.forged.empty())
      return wanted;
    std::string reason;
    try {
      validate_checkpoint(model, {});
      dynamics::Workspace work;
      dynamics::prepare(model);
      dynamics::Stepper stepper(model, work);
      stepper.advance(true);
      stepper.up_to_date();
    } catch (const hdf5::Failure& refusal) {
      reason = refusal.what();
    }
    judge(forger.forged, reason);
  }
}

TEST(ForgedCheckpoint, IsReadIfNothingIsForged) {
  const TemporaryFolder folder;
  write_checkpoint(folder / "a.ckpt.h5", full_model(), {});
  CheckpointInfo info;
  EXPECT_EQ(file_error([&] { read_checkpoint(folder / "a.ckpt.h5", info); }), "");
}

// Numbers are not finite, counts and indices are far below zero, or arrays have a row
// too many or too few.
TEST(ForgedCheckpoint, IsRefusedIfNoRunWritesTheValue) {
  long forged = 0;
  for (const auto how : {Forger::How::never, Forger::How::longer, Forger::How::shorter})
    forged += forge_all(how, [](const std::string& name, const std::string& message) {
      EXPECT_THAT(message, ::testing::StartsWith("no run writes such a state: "))
          << name;
    });
  RecordProperty("forged", std::to_string(forged));
  EXPECT_GT(forged, 300);
}

// Some run might write these values.
TEST(ForgedCheckpoint, IsRefusedOrMakesAStep) {
  long refused = 0;
  const long forged = forge_all(Forger::How::perhaps,
                                [&](const std::string&, const std::string& message) {
                                  refused += !message.empty();
                                });
  RecordProperty("forged", std::to_string(forged));
  RecordProperty("refused", std::to_string(refused));
  EXPECT_GT(refused, forged / 3);
}

TEST(ForgedCheckpoint, IsRefusedWithTheImpossibleValue) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.ckpt.h5";
  const auto message = [&](auto&& forge) {
    Model model = full_model();
    CheckpointInfo info;
    forge(model, info);
    write_checkpoint(path, model, info);
    const std::string text = file_error([&] { read_checkpoint(path, info); });
    const std::string head = "cannot read " + path + ": no run writes such a state: ";
    EXPECT_EQ(text.substr(0, head.size()), head);
    return text.substr(head.size(), text.find(';') - head.size());
  };
  EXPECT_EQ(message([](Model& m, auto&) { m.blocks.mass[1] = -3; }),
            "blocks/mass: value 2 is -3, expected a number above 0");
  EXPECT_EQ(message([](Model& m, auto&) { m.contacts[1].edge = 99; }),
            "contacts/edge: value 2 names number 100 of 8");
  EXPECT_EQ(message([](Model& m, auto&) { m.contacts[1].edge = 5; }),
            "contact 2 is between a block and itself");
  EXPECT_EQ(message([](Model& m, auto&) { std::swap(m.contacts[0], m.contacts[1]); }),
            "contact 2 is out of order");
  EXPECT_EQ(message([](Model& m, auto&) { m.contacts[1] = m.contacts[0]; }),
            "contact 2 is out of order");
  EXPECT_EQ(message([](Model& m, auto&) { m.contacts[1].overlap = -1; }),
            "contact 2: overlap is -1, expected a number from 0");
  EXPECT_EQ(
      message([](Model& m, auto&) { m.settings.joint_laws[5].residual_cohesion = 9; }),
      "settings/joint_laws: residual cohesion of id 5 is 9, expected at most the "
      "peak value");
  EXPECT_EQ(message([](Model& m, auto&) { m.settings.joint_laws[5].dilation = 0.75; }),
            "settings/joint_laws: dilation of id 5 is 0.75, expected at most the "
            "residual friction");
  EXPECT_EQ(message([](Model& m, auto&) { m.settings.joint_laws[6].tension = 1; }),
            "settings/joint_laws: tension of id 6 is 1, expected 0");
  EXPECT_EQ(
      message([](Model& m, auto&) { m.settings.joint_laws[7].roughness = 21; }),
      "settings/joint_laws: roughness of id 7 is 21, expected a number above 0, up "
      "to 20");
  EXPECT_EQ(message([](Model& m, auto&) {
              m.settings.joint_of_materials[{3, 3}] = 9;
            }),
            "settings/joint_of_materials names joint id 9, which has no law");
  EXPECT_EQ(message([](Model& m, auto&) {
              m.settings.joint_of_materials[{3, 4}] = 5;
            }),
            "settings/joint_of_materials names materials 3 and 4");
  EXPECT_EQ(message([](Model& m, auto&) { m.law_states.pop_back(); }),
            "joint_states has 1 rows, expected 2");
  EXPECT_EQ(message([](Model& m, auto&) { m.law_states[1].law = 8; }),
            "joint_states names joint id 8, which has no law");
  EXPECT_EQ(message([](Model& m, auto&) { m.law_states[1].path = -1; }),
            "joint_states/path: value 2 is -1, expected a number from 0");
  EXPECT_EQ(message([](Model& m, auto&) { m.drives[0].block = 1; }),
            "drives names block 2, which is not driven");
  EXPECT_EQ(message([](Model& m, auto&) { m.drives[0].spin = 3; }),
            "block 1 has not the velocity of its drive");
  EXPECT_EQ(message([](Model& m, auto&) { m.drives.push_back(m.drives[0]); }),
            "drive 2 is out of order");
  EXPECT_EQ(message([](Model& m, auto&) { m.servos[0].block = 1; }),
            "servos names block 2, which has no drive");
  EXPECT_EQ(message([](Model& m, auto&) { m.servos[0].max_speed = 0; }),
            "servos/most: value 1 is 0, expected a number above 0");
  EXPECT_EQ(message([](Model& m, auto&) { m.servos.push_back(m.servos[0]); }),
            "servo 2 is out of order");
  EXPECT_EQ(message([](Model& m, auto&) { m.blocks.next[3] = 1; }),
            "corner 4 of block 1 is out of order");
  EXPECT_EQ(message([](Model& m, auto&) { m.blocks.material[0] = 9; }),
            "blocks/material names material 9, which does not exist");
  EXPECT_EQ(message([](Model& m, auto&) { m.order[0] = 0; }),
            "order names block 1 twice");
  EXPECT_EQ(message([](Model& m, auto&) { m.order.pop_back(); }),
            "order has 1 rows, expected 2");
  EXPECT_EQ(message([](Model& m, CheckpointInfo& info) {
              m.time_step.block = 0, m.time_step.blocks = 1;
              m.order = {0};
              info.progress.steps_left = 5;
            }),
            "time_step/blocks is 1, but 2 blocks are in motion");
  EXPECT_EQ(message([](Model& m, auto&) { m.time = 8; }),
            "time is 8, its steps make 0.007");
  EXPECT_EQ(message([](Model& model, auto&) { model.history.quantities = {"speed"}; }),
            "history/quantities: speed needs a block or a statistic");
  EXPECT_EQ(message([](Model& model, auto&) { model.history.interval = 0; }),
            "history/quantities does not fit history/interval");
  EXPECT_EQ(message([](Model&, CheckpointInfo& info) { info.progress.frames = 2; }),
            "run/progress is beyond the end of its results or listing");
}

// The dataset is missing or is replaced by another one.
TEST(ForgedCheckpoint, IsRefusedIfAFieldIsMissing) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.ckpt.h5";
  write_checkpoint(path, full_model(), {});
  const std::string sound = contents(path);
  CheckpointInfo info;
  for (const char* name :
       {"blocks", "blocks/mass", "contacts/corner", "settings/title",
        "settings/gravity", "loads/pressures/p1", "loads/pressures/count",
        "run/progress/card", "run", "settings/merge_ratio",
        "settings/materials/density", "steps"})
    for (const char* other : {"", "contacts", "settings/title", "blocks/corner"}) {
      overwrite(path, sound);
      {
        const hdf5::Handle file = hdf5::open_file(path, true);
        if (std::string(name) == other)
          continue;
        hdf5::check(
            H5Lmove(file.get(), name, file.get(), "aside", H5P_DEFAULT, H5P_DEFAULT));
        if (*other != '\0')
          H5Lcopy(file.get(), other, file.get(), name, H5P_DEFAULT, H5P_DEFAULT);
      }
      overwrite(path, samples::sealed(contents(path)));
      EXPECT_THAT(file_error([&] { read_checkpoint(path, info); }),
                  AllOf(HasSubstr(path), Not(HasSubstr("reads format"))))
          << name << " is " << other;
    }
}

}  // namespace
}  // namespace blocks::output
