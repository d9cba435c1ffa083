#include "blocks/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>
#include <variant>

#include "deck/parser.hpp"
#include "dynamics/contacts/contact_batches.hpp"
#include "dynamics/cracks/cracking.hpp"
#include "dynamics/stepper.hpp"
#include "geometry/numeric_environment.hpp"
#include "library/results_in_use.hpp"
#include "model/equilibrium.hpp"
#include "output/checkpoint.hpp"
#include "run/builder.hpp"
#include "run/convergence.hpp"
#include "run/crack_watch.hpp"
#include "run/deck_file.hpp"
#include "run/executor.hpp"
#include "run/motion_watch.hpp"
#include "run/soundness.hpp"

namespace blocks {
namespace {

/// A CYCLE command of one step at the position of the last card that made blocks. The
/// checks before a motion are applied to it, because the caller will make the steps.
deck::Command one_step(const std::vector<deck::Command>& cards) {
  const auto makes_blocks = [](const deck::Command& command) {
    return std::holds_alternative<deck::Create>(command.card) ||
           std::holds_alternative<deck::Layer>(command.card) ||
           std::holds_alternative<deck::Read9>(command.card);
  };
  const auto maker = std::find_if(cards.rbegin(), cards.rend(), makes_blocks);
  const deck::Command& last = maker == cards.rend() ? cards.back() : *maker;
  return {last.where, last.name, deck::Cycle{{1, last.where}}};
}

Eigen::Vector2d left_of(const Vec2& from, const Vec2& to) {
  const Vec2 along = (to - from).normalized();
  return {-along.y(), along.x()};
}

int checked(int threads) {
  if (threads < 1 || threads > 1024)
    throw std::invalid_argument(
        fmt::format("{} threads are not in range 1 to 1024", threads));
  return threads;
}

}  // namespace

struct Simulation::State {
  State(std::string deck_name, std::string deck_folder, std::string deck, int threads)
      : name(std::move(deck_name)), folder(std::move(deck_folder)),
        text(std::move(deck)), work(checked(threads)) {
    if (const std::string fault = geometry::check_numeric_environment(); !fault.empty())
      throw std::runtime_error(fault);
    dynamics::kernels();
    deck::Diagnostics said(name, text);
    act(deck::parse(name, text, said), said);
  }

  /// Executes all cards. Throws DeckError with all their errors.
  void act(const deck::Deck& deck, deck::Diagnostics& said);
  void step(long count);
  /// Makes the steps of a SOLVE card, as a run does.
  void solve(const deck::Solve& card, int line);
  /// Throws UnsoundRun if an earlier step was unsound.
  void must_be_sound() const;
  /// The index of a block, from its number.
  int index(int block) const;

  std::string name, folder, text;
  Model model;
  dynamics::Workspace work;
  dynamics::Stepper stepper{model, work};
  std::vector<geometry::BlockOverlap> overlaps;  ///< reported by the certificate
  std::vector<std::string> warnings;
  std::string unsound;  ///< why a step was unsound; empty if none was
  long changes = 0;     ///< number of calls that changed the model
  std::map<std::filesystem::path, library::ResultsInUse> results;  ///< by path

 private:
  run::MotionWatch watch_;
  run::CrackWatch crack_watch_;
  double half_depth_ = 0.0;  ///< [L] half the least depth of a convex block
  void prepare(Model& on);
  /// Makes one step. Throws UnsoundRun if it was unsound.
  void advance(bool read);
  void keep_warnings(const deck::Diagnostics& said);
  void obey(Model& on, const deck::Deck& deck, deck::Diagnostics& said, bool moving);
};

void Simulation::State::keep_warnings(const deck::Diagnostics& said) {
  for (const deck::Diagnostic& diagnostic : said.all()) {
    std::string line = said.format(diagnostic);
    if (diagnostic.severity == deck::Severity::warning &&
        std::find(warnings.begin(), warnings.end(), line) == warnings.end())
      warnings.push_back(std::move(line));
  }
}

void Simulation::State::act(const deck::Deck& deck, deck::Diagnostics& said) {
  ++changes;
  // The cards are first executed on a copy in which no time passes. All errors are thus
  // found before the model changes.
  Model trial = model;
  obey(trial, deck, said, false);
  keep_warnings(said);
  if (std::none_of(deck.commands.begin(), deck.commands.end(), deck::passes_time)) {
    model = std::move(trial);
  } else {
    deck::Diagnostics later(said.file(), deck.text);
    obey(model, deck, later, true);
    keep_warnings(later);
  }
  if (model.blocks.count_present() > 0)
    prepare(model);
}

/// Prepares the model for steps and records a warning for each block outside the
/// domain.
void Simulation::State::prepare(Model& on) {
  dynamics::prepare(on);
  stepper.changed();
  for (std::string& told : watch_.after(on, {}))
    warnings.push_back(std::move(told));
}

/// Executes the cards on a model and throws DeckError after the last card if there were
/// errors. If `moving` is false, MOTION, CYCLE and SOLVE are checked, but no time
/// passes.
void Simulation::State::obey(Model& on, const deck::Deck& deck, deck::Diagnostics& said,
                             bool moving) {
  const auto stop_at_faults = [&] {
    if (said.has_errors())
      throw DeckError(said.format_all());
  };
  if (!deck.commands.empty())
    if (const auto* card = std::get_if<deck::Restart>(&deck.commands.front().card)) {
      if (!card->file.given) {
        said.error(deck.commands.front().where, "RESTART",
                   "the name of the checkpoint is missing", "write RESTART, file");
        stop_at_faults();
      }
      output::CheckpointInfo from;
      on = output::read_checkpoint(run::beside(folder, card->file.value), from);
      overlaps = from.progress.overlaps;
      watch_ = run::MotionWatch(on, from.progress.fast_told, from.progress.flight_told);
      crack_watch_ = run::CrackWatch(on);
    }
  const int judged = on.blocks.size();
  run::Builder builder(on, said, deck.commands,
                       {.seed = {},
                        .tape9 = "tape9",
                        .folder = folder,
                        .unread = deck.unread,
                        .overlaps = overlaps,
                        .moves = moving});
  bool in_place = true;
  for (const deck::Command& command : deck.commands) {
    builder.apply(command);
    if (!deck::passes_time(command))
      continue;
    if (moving || !said.has_errors())
      builder.check_before_motion(command, in_place);
    in_place = moving;
    if (!moving)
      continue;
    stop_at_faults();
    prepare(on);
    if (const auto* motion = std::get_if<deck::Motion>(&command.card))
      step(run::steps_for(motion->dt.value, on.time_step.dt));
    else if (const auto* cycle = std::get_if<deck::Cycle>(&command.card))
      step(cycle->ncycle.value);
    else
      solve(std::get<deck::Solve>(command.card), command.where.line);
  }
  if (in_place && !said.has_errors() && on.blocks.size() > judged &&
      on.blocks.count_present() > 0)
    builder.check_before_motion(one_step(deck.commands), true);
  stop_at_faults();
  if (const auto& certificate = builder.certificate())
    overlaps = certificate->overlaps;
}

void Simulation::State::advance(bool read) {
  const dynamics::StepResult moved =
      stepper.advance(read, model.settings.normal_stiffness * half_depth_);
  for (std::string& told : watch_.after(model, moved))
    warnings.push_back(std::move(told));
  if (watch_.is_flight_due(model))
    if (std::string told = watch_.flight(stepper.up_to_date()); !told.empty())
      warnings.push_back(std::move(told));
  if (run::may_be_unsound(model.settings, moved, half_depth_)) {
    unsound = run::unsound(stepper.up_to_date(), moved, half_depth_);
    if (!unsound.empty())
      throw UnsoundRun(unsound);
  }
  if (!dynamics::may_crack(model.settings))
    return;
  if (stepper.crack() > 0)
    half_depth_ = run::half_depth(model.blocks);
  for (std::string& told : crack_watch_.after(model).warnings)
    warnings.push_back(std::move(told));
}

void Simulation::State::step(long count) {
  half_depth_ = run::half_depth(model.blocks);
  for (long i = 1; i <= count; ++i)
    advance(i == count);
  stepper.up_to_date();
}

void Simulation::State::solve(const deck::Solve& card, int line) {
  half_depth_ = run::half_depth(model.blocks);
  run::Convergence convergence(card);
  while (!convergence.is_finished()) {
    const bool tested = convergence.is_due();
    advance(tested);
    convergence.after_step(tested ? stepper.up_to_date() : model);
  }
  model.solves.push_back(convergence.record(model, line));
  if (const SolveRecord& solve = model.solves.back(); !solve.converged)
    warnings.push_back(run::solve_warning(solve, model.settings));
}

void Simulation::State::must_be_sound() const {
  if (!unsound.empty())
    throw UnsoundRun("cannot continue an unsound run: " + unsound);
}

int Simulation::State::index(int block) const {
  const int count = model.blocks.size();
  if (block < 1 || block > count)
    throw std::out_of_range(
        count == 0
            ? fmt::format("there is no block {}, the model has no blocks", block)
            : fmt::format("there is no block {}, blocks are 1 to {}", block, count));
  return block - 1;
}

Simulation::Simulation(const std::string& deck, int threads)
    : state_(std::make_unique<State>("cards", "", deck, threads)) {}
Simulation::Simulation(std::unique_ptr<State> state) : state_(std::move(state)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Simulation Simulation::from_file(const std::string& path, int threads) {
  return Simulation(std::make_unique<State>(path, run::deck_folder(path),
                                            run::read_deck(path), threads));
}

void Simulation::cards(const std::string& text) {
  state_->must_be_sound();
  deck::Diagnostics said(state_->name, text);
  state_->act(deck::parse_further(state_->name, text, said), said);
}

const std::vector<std::string>& Simulation::warnings() const {
  return state_->warnings;
}

void Simulation::step(long count) {
  if (count < 0)
    throw std::invalid_argument(
        fmt::format("the number of steps is negative: {}", count));
  if (state_->model.blocks.count_present() == 0)
    throw std::logic_error("there are no blocks to move");
  state_->must_be_sound();
  state_->step(count);
}

long Simulation::steps() const { return state_->model.steps; }
double Simulation::time() const { return state_->model.time; }
double Simulation::time_step() const { return state_->model.time_step.dt; }

int Simulation::blocks() const { return state_->model.blocks.size(); }
int Simulation::material(int block) const {
  return state_->model.blocks.material[state_->index(block)];
}
bool Simulation::is_free(int block) const {
  return state_->model.blocks.is_free(state_->index(block));
}
double Simulation::area(int block) const {
  return state_->model.blocks.area[state_->index(block)];
}
double Simulation::mass(int block) const {
  return state_->model.blocks.mass[state_->index(block)];
}
Eigen::Matrix2Xd Simulation::corners(int block) const {
  const Blocks& all = state_->model.blocks;
  const int b = state_->index(block);
  return all.corner.middleCols(all.first_corner[b], all.corners_of(b));
}
Eigen::Vector2d Simulation::centroid(int block) const {
  return state_->model.blocks.centroid.col(state_->index(block));
}
Eigen::Vector2d Simulation::velocity(int block) const {
  return state_->model.blocks.velocity.col(state_->index(block));
}
double Simulation::angle(int block) const {
  return state_->model.blocks.angle[state_->index(block)];
}
double Simulation::spin(int block) const {
  return state_->model.blocks.spin[state_->index(block)];
}
Eigen::Vector2d Simulation::force(int block) const {
  return state_->model.blocks.force.col(state_->index(block));
}
double Simulation::moment(int block) const {
  return state_->model.blocks.moment[state_->index(block)];
}
Eigen::Matrix2d Simulation::stress(int block) const {
  const auto s = state_->model.blocks.stress.col(state_->index(block));
  return (Eigen::Matrix2d() << s[0], s[1], s[2], s[3]).finished();
}

std::vector<ContactForce> Simulation::contacts() const {
  const Model& model = state_->model;
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
  const PlaneContacts& on_planes = model.plane_contacts;
  for (int i = 0; i < on_planes.size(); ++i) {
    const int c = on_planes.corner[i];
    const Plane& plane = model.settings.planes[on_planes.plane[i]];
    if (on_planes.active[i])
      acting.push_back({all.corner_block[c] + 1, number(c), 0, on_planes.plane[i] + 1,
                        all.corner.col(c), left_of(plane.a, plane.b),
                        on_planes.normal_force[i], 0.0, on_planes.overlap[i]});
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
  return totals(state_->model).kinetic_energy;
}
double Simulation::unbalanced_ratio() const {
  return blocks::unbalanced_ratio(state_->model);
}
double Simulation::worst_overlap() const { return state_->model.worst_overlap; }

void Simulation::set_velocity(int block, const Eigen::Vector2d& velocity, double spin) {
  Blocks& all = state_->model.blocks;
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
  state_->stepper.changed();
  ++state_->changes;
}

void Simulation::write_frame(const std::string& path) {
  State& state = *state_;
  const Settings& settings = state.model.settings;
  const auto [file, begun] = state.results.try_emplace(
      library::file_of(path), path,
      output::RunIdentity{state.name, state.text, settings.title, BLOCKS_VERSION,
                          settings.seed});
  file->second.write(state.model, state.changes);
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
  output::write_checkpoint(path, state_->model, info);
}

}  // namespace blocks
