#include "blocks/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "files/file_tools.hpp"
#include "library/simulation_state.hpp"
#include "model/equilibrium.hpp"
#include "output/checkpoint/checkpoint.hpp"
#include "run/cutting/joint_files.hpp"
#include "run/support/deck_file.hpp"

namespace blocks {
namespace {

Eigen::Vector2d left_of(const Vec2& from, const Vec2& to) {
  const Vec2 along = (to - from).normalized();
  return {-along.y(), along.x()};
}

}  // namespace

Simulation::Simulation(const std::string& deck, int threads, Motions motions)
    : state_(std::make_unique<State>("cards", "", deck, threads, motions)) {}
Simulation::Simulation(std::unique_ptr<State> state) : state_(std::move(state)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Simulation Simulation::from_file(const std::string& path, int threads,
                                 Motions motions) {
  return Simulation(std::make_unique<State>(path, run::deck_folder(path),
                                            run::read_deck(path), threads, motions));
}

void Simulation::cards(const std::string& text) {
  state_->must_be_sound();
  deck::Diagnostics diagnostics("cards", text);
  deck::Deck further = deck::parse_further("cards", text, diagnostics);
  run::read_outline_files(further, state_->folder, diagnostics);
  state_->execute(further, diagnostics);
}

const std::vector<std::string>& Simulation::warnings() const {
  return state_->warnings;
}

void Simulation::step(long count, bool read) {
  if (count < 0)
    throw std::invalid_argument(
        fmt::format("the number of steps is negative: {}", count));
  if (state_->blocks().count_present() == 0)
    throw std::logic_error("there are no blocks to move");
  state_->must_be_sound();
  state_->step(count, read);
}

bool Simulation::is_read() const { return state_->contacts_known; }
long Simulation::steps() const { return state_->model.steps; }
double Simulation::time() const { return state_->model.time; }
double Simulation::time_step() const { return state_->model.time_step.dt; }

int Simulation::blocks() const { return state_->model.blocks.size(); }
int Simulation::material(int block) const {
  return state_->blocks().material[state_->index(block)];
}
bool Simulation::is_free(int block) const {
  return state_->blocks().is_free(state_->index(block));
}
double Simulation::area(int block) const {
  return state_->blocks().area[state_->index(block)];
}
double Simulation::mass(int block) const {
  return state_->blocks().mass[state_->index(block)];
}
Eigen::Matrix2Xd Simulation::corners(int block) const {
  const Blocks& all = state_->blocks();
  const int b = state_->index(block);
  return all.corner.middleCols(all.first_corner[b], all.corners_of(b));
}
Eigen::Vector2d Simulation::centroid(int block) const {
  return state_->blocks().centroid.col(state_->index(block));
}
Eigen::Vector2d Simulation::velocity(int block) const {
  return state_->blocks().velocity.col(state_->index(block));
}
double Simulation::angle(int block) const {
  return state_->blocks().angle[state_->index(block)];
}
double Simulation::spin(int block) const {
  return state_->blocks().spin[state_->index(block)];
}
Eigen::Vector2d Simulation::force(int block) const {
  return state_->blocks().force.col(state_->index(block));
}
double Simulation::moment(int block) const {
  return state_->blocks().moment[state_->index(block)];
}
Eigen::Matrix2d Simulation::stress(int block) const {
  const auto s = state_->blocks().stress.col(state_->index(block));
  return (Eigen::Matrix2d() << s[0], s[1], s[2], s[3]).finished();
}

std::vector<ContactForce> Simulation::contacts() const {
  state_->must_be_read();
  const Model& model = state_->current();
  const Blocks& all = model.blocks;
  const auto number = [&](int corner) {  // number within its block, from 1
    return corner - all.first_corner[all.corner_block[corner]] + 1;
  };
  std::vector<ContactForce> acting;
  for (const Contact& contact : model.contacts) {
    const int c = contact.corner, e = contact.edge;
    acting.push_back({all.corner_block[c] + 1, number(c), all.corner_block[e] + 1,
                      number(e), all.corner.col(c),
                      left_of(all.corner.col(e), all.corner.col(all.next[e])),
                      contact.normal_force, contact.shear_force, contact.overlap});
  }
  for (const PlaneContact& contact : model.plane_contacts) {
    const int c = contact.corner;
    const Plane& plane = model.settings.planes[contact.plane];
    if (contact.active)
      acting.push_back({all.corner_block[c] + 1, number(c), 0, contact.plane + 1,
                        all.corner.col(c), left_of(plane.a, plane.b),
                        contact.normal_force, 0.0, contact.overlap});
  }
  return acting;
}

Eigen::Vector2d Simulation::contact_force(int block) const {
  state_->index(block);
  Eigen::Vector2d sum(0, 0);
  for (const ContactForce& contact : contacts()) {
    if (contact.corner_block == block)
      sum += contact.force();
    if (contact.edge_block == block)
      sum -= contact.force();
  }
  return sum;
}

double Simulation::kinetic_energy() const {
  return totals(state_->current()).kinetic_energy;
}
double Simulation::unbalanced_ratio() const {
  return blocks::unbalanced_ratio(state_->current());
}
double Simulation::worst_overlap() const { return state_->model.worst_overlap; }

void Simulation::set_velocity(int block, const Eigen::Vector2d& velocity, double spin) {
  Blocks& all = state_->blocks();
  const int b = state_->index(block);
  if (!all.is_free(b))
    throw std::logic_error(
        fmt::format("block {} is {}", block, all.is_removed(b) ? "removed" : "fixed"));
  if (!velocity.allFinite() || !std::isfinite(spin))
    throw std::invalid_argument(
        fmt::format("the velocity of block {} is not a number", block));
  state_->must_be_sound();
  all.velocity.col(b) = velocity;
  all.spin[b] = spin;
  state_->take_velocities_and_loads();
}

void Simulation::set_force(int block, const Eigen::Vector2d& force) {
  const int b = state_->index(block);
  if (!force.allFinite())
    throw std::invalid_argument(
        fmt::format("the force on block {} is not a number", block));
  state_->must_be_sound();
  std::vector<CentroidForce>& forces = state_->current().loads.forces;
  const auto own = std::find_if(forces.begin(), forces.end(), [&](const auto& load) {
    return load.block == b && load.is_constant();
  });
  if (own != forces.end())
    forces.erase(own);
  if (force != Eigen::Vector2d::Zero())
    forces.push_back({b, force, TimeFunction::always});
  state_->take_velocities_and_loads();
}

void Simulation::write_frame(const std::string& path) {
  State& state = *state_;
  const Settings& settings = state.model.settings;
  const auto [file, begun] = state.results.try_emplace(
      library::file_of(path), path,
      output::RunIdentity{state.name, state.text, settings.title, BLOCKS_VERSION,
                          settings.seed});
  file->second.write(state.current(), state.changes);
}

void Simulation::write_checkpoint(const std::string& path) const {
  state_->must_be_sound();
  // The deck's text is omitted because this state is not a position in a deck at which
  // a run could resume.
  output::CheckpointInfo info;
  info.deck_file = state_->name;
  info.version = BLOCKS_VERSION;
  info.progress.finished = true;
  info.progress.overlaps = state_->overlaps;
  if (state_->checkpoints.insert(library::file_of(path)).second)
    for (const std::string& older : {path, path + ".prev"})
      files::set_aside(older);
  output::write_checkpoint(path, state_->current(), info);
}

}  // namespace blocks
