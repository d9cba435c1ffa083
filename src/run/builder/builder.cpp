#include "run/builder/builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <set>
#include <utility>

#include "deck/mesh/mesh_readers.hpp"
#include "model/drives.hpp"
#include "model/safe_fraction.hpp"
#include "run/builder/build_blocks.hpp"
#include "run/builder/deck_outlines.hpp"
#include "run/builder/history_card.hpp"
#include "run/builder/units_check.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::run {

using deck::Command;

namespace {

/// The number of blocks that a card should make at most.
long max_new_blocks(const Command& command) {
  constexpr long any = deck::UnreadCard::any_number_of_blocks;
  if (const auto* create = std::get_if<deck::Create>(&command.card))
    return create->loop ? std::min(create->loop->nloop.value, any) : 1;
  if (const auto* layer = std::get_if<deck::Layer>(&command.card))
    return std::min(std::abs(layer->ns.value), any);
  return std::holds_alternative<deck::Read9>(command.card) ||
                 std::holds_alternative<deck::Cut>(command.card)
             ? any
             : 0;
}

/// Returns the outline of a CUT card as given, with rounded corners.
geometry::Polygon outline_of_cut(const deck::Cut& card) {
  std::vector<geometry::DecimalPoint> corners;
  for (std::size_t i = 0; i < card.outline.x.size(); ++i)
    corners.push_back({card.outline.x[i].value, card.outline.y[i].value});
  return geometry::place_outline(corners, {}, 0);
}

}  // namespace

BuilderState::BuilderState(const Model& model, const std::vector<Command>& cards,
                           BuildOptions options)
    : options_(std::move(options)), unread_(options_.unread),
      certain_blocks_(model.blocks.size()), corners_(shared_corners(cards)),
      makers_(model.blocks.size()), domain_blocks_(model.blocks.size()),
      known_blocks_(model.blocks.size()), checked_blocks_(model.blocks.size()),
      moved_blocks_(model.steps > 0 ? model.blocks.size() : 0) {
  std::size_t moved = 0;
  for (const geometry::SharedCorners& section : corners_)
    moved += section.moved();
  if (moved > 0)
    notes_.push_back(fmt::format("corners on a slanted side of another outline, "
                                 "rounded so that they do not overlap it: {}",
                                 moved));
}

void BuilderState::begin_to_move() {
  moves_ = in_place_ = true;
  sure_blocks_.reset();
  notes_.clear();
  // An interrupt ends a run between steps, not in the middle of a card.
  options_.cut_progress = {};
  options_.check_progress = {};
}

Builder::Builder(Model& model, deck::Diagnostics& diagnostics,
                 const std::vector<Command>& cards, BuildOptions options)
    : BuilderState(model, cards, std::move(options)), model_(model),
      diagnostics_(diagnostics) {
  if (options_.seed)
    model_.settings.seed = *options_.seed;
}

/// Executes a card; there is one function per card.
struct Builder::Visitor {
  Builder& self;
  const Command& command;
  Model& model = self.model_;
  Settings& settings = self.model_.settings;
  Blocks& blocks = self.model_.blocks;

  void error(deck::SourceLocation where, const std::string& message,
             const std::string& hint = {}) {
    self.diagnostics_.error(where, command.name, message, hint);
  }
  BlockBuilder builder() {
    return {model,        self.diagnostics_,    command, self.corners_[self.section_],
            self.unread_, self.missing_.count()};
  }

  // Preliminary data, A.1
  void operator()(const deck::Start& card) {
    settings.title = card.title;
    settings.max_blocks = static_cast<int>(std::min(card.nblok.value, 1'000'000'000L));
    settings.max_corners = static_cast<int>(std::min(card.ncmx.value, 1'000'000'000L));
  }
  void operator()(const deck::XLimits& card) {
    settings.lower.x() = card.xmin.value;
    settings.upper.x() = card.xmax.value;
    self.places_.x_limits = command.where;
  }
  void operator()(const deck::YLimits& card) {
    settings.lower.y() = card.ymin.value;
    settings.upper.y() = card.ymax.value;
    self.places_.y_limits = command.where;
  }
  void operator()(const deck::Boxes& card) {
    constexpr long max = 100'000'000;  // 400 MB of box pointers
    if (card.iboxes.value > max || card.jboxes.value > max / card.iboxes.value) {
      error(card.iboxes.where, "too many boxes",
            fmt::format("iboxes times jboxes may be {} at most", max));
      return;
    }
    settings.boxes_x = static_cast<int>(card.iboxes.value);
    settings.boxes_y = static_cast<int>(card.jboxes.value);
    settings.contact_tolerance = card.ctol.value;
    self.places_.tolerance = card.ctol.where;
  }
  void operator()(const deck::Stiff& card) {
    settings.normal_stiffness = card.stifn.value;
    settings.shear_stiffness = card.stifs.value;
    self.places_.stiffness = card.stifn.where;
  }
  void operator()(const deck::Fraction& card) {
    settings.fraction = card.tfrac.value;
    self.fraction_by_ = command;
  }
  void operator()(const deck::Material& card) {
    settings.materials[static_cast<int>(card.mat.value)] = {
        card.e.value, card.g.value, card.rho.value, card.name.value};
    materials.emplace_back(command, card);
    self.places_.modulus[static_cast<int>(card.mat.value)] = card.e.where;
  }
  void operator()(const deck::Function& card) {
    for (const deck::Real& t : card.t)
      model.loads.function.t.push_back(t.value);
    for (const deck::Real& p : card.p)
      model.loads.function.p.push_back(p.value);
    for (std::size_t i = 1; i < card.t.size(); ++i)
      if (card.t[i - 1].value == card.t[i].value)
        self.notes_.push_back(
            fmt::format("FUNCTION in line {}: a step from {:g} to {:g} at t = {:g}",
                        card.t[i].where.line, card.p[i - 1].value, card.p[i].value,
                        card.t[i].value));
  }
  void operator()(const deck::Rigid&) { settings.rigid = true; }
  void operator()(const deck::Seed& card) {
    if (!self.options_.seed)
      settings.seed = static_cast<std::uint64_t>(card.seed.value);
  }
  void operator()(const deck::Units& card) {
    check_units(card, self.diagnostics_);
    settings.units = {card.length.value, card.mass.value, card.time.value};
  }
  void operator()(const deck::End&) {
    if (settings.rigid || self.unread_.has("RIGID"))
      return;
    for (const auto& [where, card] : self.materials_)
      check_elastic(where, card);
  }
  void check_elastic(const Command& where, const deck::Material& card) {
    const double e = card.e.value, g = card.g.value;
    const auto say = [&](deck::SourceLocation at, const std::string& message) {
      self.diagnostics_.error(at, where.name, message,
                              "or make the blocks rigid with a RIGID card");
    };
    if (!(e > 0.0))
      say(card.e.where, "deformable blocks need E > 0");
    else if (!(g > 0.0))
      say(card.g.where, "deformable blocks need G > 0");
    else if (!(g > e / 3.0))
      say(card.g.where,
          fmt::format("deformable blocks need G > E/3 = {:.9g} (Poisson's ratio < 0.5)",
                      e / 3.0));
  }
  void operator()(const deck::Restart&) {}  // the checkpoint is loaded elsewhere

  // Problem definition data, A.2
  void operator()(const deck::Create& card) { builder().create(card); }
  void operator()(const deck::Read9& card) {
    const std::string path = mesh_path(card, self.options_.folder, self.options_.tape9);
    if (std::string found = builder().read_mesh(card, path); !found.empty())
      self.notes_.push_back(std::move(found));
  }
  void operator()(const deck::Layer& card) { builder().layer(card); }
  void operator()(const deck::Cut& card) {
    self.last_outline_ = outline_of_cut(card);
    CutOptions options{settings.seed, self.options_.folder, settings.units.length};
    if (settings.max_blocks > 0)
      options.max_new_blocks = settings.max_blocks - blocks.size();
    if (self.options_.cut_progress)
      options.progress = [&](const std::string& step, double part) {
        self.options_.cut_progress(command.where.line, step, part);
      };
    for (std::string& line : builder().cut(card, options))
      self.notes_.push_back(std::move(line));
    if (options.progress)
      options.progress("", 1.0);
  }
  void operator()(const deck::Orient& card) {
    settings.angle_min = card.angmin.value;
    settings.angle_max = card.angplus.value;
  }
  void operator()(const deck::Merge& card) { settings.merge_ratio = card.aratio.value; }
  void operator()(const deck::Splane& card) {
    const Plane plane = {{card.x1.value, card.y1.value},
                         {card.x2.value, card.y2.value}};
    settings.planes.push_back(plane);
    self.check_plane_in_ground(command, plane);
    model.search.invalidate();
    self.places_.planes[settings.planes.size() - 1] = command.where;
    self.planes_.push_back(command);
  }
  void operator()(const deck::Gravity& card) {
    settings.gravity_ramp = {settings.gravity_at(model.time), model.time,
                             card.tramp.value};
    settings.gravity = {card.gravx.value, card.gravy.value};
    self.check_direction_of_water(command);
  }
  void operator()(const deck::Fix& card) {
    for (const int b : self.blocks_named(command, card.nblok)) {
      blocks.fix(b, Fixity::by_user);
      end_drive(model, b);
      model.search.invalidate();
    }
    self.perhaps_fixed_ |= card.nblok.selector && !self.in_place_;
  }
  void operator()(const deck::Remove& card) { self.remove(command, card.blocks); }
  void operator()(const deck::Free& card) { self.free(command, card.blocks); }
  void operator()(const deck::PressBc& card) { self.press(command, card); }
  void operator()(const deck::Force& card) { self.push(command, card); }
  void operator()(const deck::Water& card) { self.set_water(command, card); }
  void operator()(const deck::Jwater& card) { self.set_joint_water(command, card); }
  void operator()(const deck::Frictn& card) { settings.friction = card.fric.value; }
  void operator()(const deck::SetVel& card) {
    set_velocity(card.nb1.selector
                     ? self.blocks_named(command, card.nb1)
                     : self.blocks_in_range(command, card.nb1.number, card.nb2),
                 card.nb1.where(), card);
  }
  void operator()(const deck::SetVelM& card) {
    set_velocity(self.blocks_of_material(command, card.mat), card.mat.where, card);
  }
  void set_velocity(std::vector<int> chosen, deck::SourceLocation where,
                    const auto& card) {
    self.leave_out_removed(command, where, chosen);
    for (const int b : chosen) {
      if (!blocks.is_free(b))
        continue;
      blocks.velocity.col(b) = Vec2(card.vx.value, card.vy.value);
      blocks.spin[b] = card.tdot.value;
    }
  }
  void operator()(const deck::Damping& card) {
    settings.damping = card.beta.value;
    choose_step_again();
  }
  /// The damping has changed.
  void choose_step_again() {
    self.fraction_by_ = command;
    if (chooses_fraction(settings))
      model.time_step.blocks = 0;
  }
  void operator()(const deck::Joint& card) { self.define_joint(command, card); }
  void operator()(const deck::Walton& card) { self.define_walton(command, card); }
  void operator()(const deck::Barton& card) { self.define_barton(command, card); }
  void operator()(const deck::Jpair& card) { self.pair_materials(command, card); }
  void operator()(const deck::Bond& card) { self.bond(command, card); }
  void operator()(const deck::Drive& card) { self.drive(command, card); }
  void operator()(const deck::Locdamp& card) {
    settings.local_damping = card.alpha.value;
    choose_step_again();
  }
  void operator()(const deck::Kindamp& card) {
    settings.kinetic_damping = card.on.value != 0;
    model.last_kinetic_energy = 0.0;
  }
  void operator()(const deck::Mscale& card) {
    settings.mass_scaling = card.on.value != 0;
  }
  void operator()(const deck::Insitu& card) {
    self.balanced_ = true;
    self.load_in_situ(command, card);
  }
  void operator()(const deck::Servo& card) { self.servo(command, card); }
  void operator()(const deck::Quiet& card) { self.make_quiet(command, card); }
  void operator()(const deck::Crack& card) { self.let_crack(command, card); }
  void operator()(const deck::Mdamp& card) { self.damp_material(command, card); }
  void operator()(const deck::Output& card) {
    model.output_blocks = self.output_blocks(command, card);
    self.output_ = command;  // its blocks may be made later
    model.output = {card.dtout.value, model.time + card.dtout.value};
  }
  void operator()(const deck::Plots& card) {
    model.plots = {}, model.plot_steps = {};
    if (card.steps.given)
      model.plot_steps = {card.steps.value, model.steps};
    else
      model.plots = {card.dtplot.value, model.time + card.dtplot.value};
    std::set<double> times;
    for (const deck::Real& time : card.times)
      times.insert(time.value);
    model.plot_times.assign(times.begin(), times.end());
  }
  void operator()(const deck::History& card) {
    model.history = {card.dthist.value, {}};
    const quantities::MaterialNumbers numbers = material_numbers(settings);
    const Command numbered = self.with_numbers(command);
    for (const NamedCurve& named : named_curves(numbered, self.diagnostics_)) {
      const std::string& material = named.curve.material;
      const int number = quantities::material_number(material, numbers);
      const bool may_be_unread = self.unread_.may_define(number, settings) ||
                                 (number == 0 && self.unread_.has("MATERIAL"));
      if (!material.empty() && !settings.materials.contains(number) && !may_be_unread)
        self.error_no_material(command, named.where, material);
      model.history.quantities.push_back(named.curve.name());
    }
    self.histories_.push_back(numbered);  // its blocks may be made later
  }
  void operator()(const deck::Dump&) {}
  void operator()(const deck::Save&) {}
  void operator()(const deck::Fos&) {
    self.check_damping(command);
    self.check_equilibrium(command);
    pass_time();
  }
  void operator()(const deck::Motion&) { pass_time(); }
  void operator()(const deck::Cycle&) { pass_time(); }
  void operator()(const deck::Solve&) {
    self.balanced_ = true;
    self.check_damping(command);
    pass_time();
  }
  void pass_time() {
    ++self.section_;
    self.in_place_ = self.moves_;
    if (!self.in_place_ && !settings.crack_rules.empty() && !self.sure_blocks_)
      self.sure_blocks_ = self.last_number();
  }
  void operator()(const deck::Stop&) {}

  std::vector<std::pair<Command, deck::Material>>& materials = self.materials_;
};

void Builder::apply(const Command& command) {
  take_in_pieces();
  count_blocks(command.where.line);
  const int before = model_.blocks.size();
  chosen_.clear();
  std::visit(Visitor{*this, command}, command.card);
  plausibility_.test(Moment::card, plan({&command, 1}), command, diagnostics_);
  if (model_.blocks.size() == before) {
    const long failed = max_new_blocks(command);
    failed_blocks_ += failed;
    if (std::holds_alternative<deck::Create>(command.card))
      missing_.add(before, failed);
  }
  count_blocks(command.where.line);
  makers_.record(command, model_.blocks.size());
  known_blocks_ = model_.blocks.size();
  if (deck::passes_time(command))
    motion_ = command;
}

void Builder::go_on(const std::vector<Command>& cards, std::size_t next,
                    const std::vector<geometry::BlockOverlap>& overlaps) {
  section_ = static_cast<std::size_t>(
      std::count_if(cards.begin(), cards.begin() + static_cast<std::ptrdiff_t>(next),
                    deck::passes_time));
  balanced_ =
      std::any_of(cards.begin(), cards.begin() + static_cast<std::ptrdiff_t>(next),
                  [](const Command& command) {
                    return std::holds_alternative<deck::Solve>(command.card) ||
                           std::holds_alternative<deck::Insitu>(command.card);
                  });
  AssemblyCertificate certificate;
  certificate.blocks = certificate.moved = model_.blocks.size();
  certificate.removed = certificate.blocks - model_.blocks.count_present();
  certificate.overlaps = overlaps;
  certificate_ = std::make_shared<const AssemblyCertificate>(std::move(certificate));
  warned_fraction_ = safe_fraction(model_.settings);
  known_blocks_ = checked_blocks_ = moved_blocks_ = model_.blocks.size();
}

}  // namespace blocks::run
