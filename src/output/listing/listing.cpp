#include "output/listing/listing.hpp"

#include <filesystem>
#include <numeric>

#include "files/file_error.hpp"
#include "output/listing/listing_text.hpp"
#include "quantities/energy.hpp"
#include "text/counted.hpp"

namespace blocks::output {
namespace {

/// Returns the line below a SOLVE that has scaled masses; otherwise empty.
std::string scaling_text(const SolveRecord& solve) {
  if (solve.min_scale == 1.0 && solve.largest_scale == 1.0)
    return "";
  return fmt::format("          masses scaled by {:.6g} to {:.6g}, time step {:.6g}\n",
                     solve.min_scale, solve.largest_scale, solve.dt);
}

}  // namespace

Listing::Listing(const std::string& path, bool append)
    : out_(path, append ? std::ios::app : std::ios::trunc), path_(path) {
  if (!out_)
    files::throw_errno("write", path_);
}

long Listing::size() {
  flush();
  std::error_code ignored;
  const auto bytes = std::filesystem::file_size(path_, ignored);
  return ignored ? 0 : static_cast<long>(bytes);
}

void Listing::flush() {
  out_.flush();
  if (!out_)
    files::throw_errno("write", path_);
}

void Listing::deck_echo(const RunIdentity& identity) {
  // The folder is omitted, so that the listing does not depend on where the deck is.
  const std::string deck =
      std::filesystem::path(identity.deck_file).filename().string();
  out_ << fmt::format("BLOCKS {}    two-dimensional block motion\n\n{}\n",
                      identity.version, identity.title)
       << heading("DECK " + deck);
  std::string_view text = identity.deck_text;
  for (int line = 1; !text.empty(); ++line) {
    const auto end = text.find('\n');
    std::string_view shown = text.substr(0, end);
    if (shown.ends_with('\r'))
      shown.remove_suffix(1);
    const char* gap = shown.empty() ? "" : "  ";
    out_ << fmt::format("{:>6}{}{}\n", line, gap, shown);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  flush();
}

void Listing::message(const std::string& line) {
  out_ << "\n" << line << "\n";
  flush();
}

void Listing::table(const Model& model) {
  const Blocks& blocks = model.blocks;
  std::vector<int> chosen = model.output_blocks;
  if (chosen.empty()) {
    chosen.resize(static_cast<std::size_t>(blocks.size()));
    std::iota(chosen.begin(), chosen.end(), 0);
  }
  std::erase_if(chosen, [&](int b) { return b < 0 || b >= blocks.size(); });

  out_ << heading(
      fmt::format("OUTPUT    time {:.9g}    step {}", model.time, model.steps));
  out_ << over_whole("block") << over_whole("") << over_number("x") << over_number("y")
       << over_number("angle") << over_number("vx") << over_number("vy")
       << over_number("spin") << "\n";
  for (const int b : chosen)
    out_ << whole(b + 1) << fixity_word(blocks.fixity[static_cast<std::size_t>(b)])
         << number(blocks.centroid(0, b)) << number(blocks.centroid(1, b))
         << number(blocks.angle[b]) << number(blocks.velocity(0, b))
         << number(blocks.velocity(1, b)) << number(blocks.spin[b]) << "\n";
  out_ << "\n"
       << over_whole("block") << over_number("fx") << over_number("fy")
       << over_number("moment") << over_number("stress 11") << over_number("stress 12")
       << over_number("stress 21") << over_number("stress 22") << "\n";
  for (const int b : chosen) {
    out_ << whole(b + 1) << number(blocks.force(0, b)) << number(blocks.force(1, b))
         << number(blocks.moment[b]);
    for (int i = 0; i < 4; ++i)
      out_ << number(blocks.stress(i, b));
    out_ << "\n";
  }
  flush();
}

void Listing::closing(const Model& model) {
  const ModelTotals sums = totals(model);
  const auto line = [this](const char* what, const std::string& value) {
    out_ << fmt::format("  {:<34}{:>17}\n", what, value);
  };
  const auto real = [](double value) { return fmt::format("{:.9g}", value); };
  out_ << heading("END OF RUN");
  line("time", real(model.time));
  line("steps", fmt::format("{}", model.steps));
  line("blocks", fmt::format("{}", model.blocks.size()));
  if (const int present = model.blocks.count_present(); present < model.blocks.size())
    line("removed blocks", fmt::format("{}", model.blocks.size() - present));
  line("contacts listed", fmt::format("{}", sums.listed_contacts));
  line("contacts active", fmt::format("{}", sums.active_contacts));
  line("contact list updates", fmt::format("{}", model.search.updates));
  line("kinetic energy", real(sums.kinetic_energy));
  line("momentum in x", real(sums.momentum.x()));
  line("momentum in y", real(sums.momentum.y()));
  line("angular momentum about the origin", real(sums.angular_momentum));
  line("worst overlap", real(sums.worst_overlap));
  line("largest speed", real(sums.fastest));
  line("blocks that left the domain", fmt::format("{}", model.exits.size()));
  if (!model.settings.crack_rules.empty() || !model.cracks.empty()) {
    line("cracks", fmt::format("{}", model.cracks.size()));
    for (int i = 0; i < crack_refusals; ++i) {
      const auto why = static_cast<CrackRefusal>(i);
      if (const std::size_t refused = count_refused(model.crack_refusals, why))
        out_ << fmt::format("    {} did not split at first: {}\n",
                            counted(refused, "block"), describe(why));
    }
  }
  for (const DomainExit& exit : model.exits)
    out_ << fmt::format("    block {} at time {:.9g}\n", exit.block + 1, exit.time);
  if (!model.solves.empty()) {
    out_ << heading("SOLVE (ratio of the unbalanced forces, largest local ratio)")
         << over_whole("line") << over_number("wanted") << over_number("reached")
         << over_number("local wanted") << over_number("reached")
         << over_whole("of block") << over_whole("steps") << over_number("time")
         << "    converged\n";
    for (const SolveRecord& solve : model.solves)
      out_ << whole(solve.line) << number(solve.wanted) << number(solve.reached)
           << number(solve.wanted_local) << number(solve.reached_local)
           << (solve.local_block < 0 ? over_whole("-") : whole(solve.local_block + 1))
           << whole(solve.steps) << number(solve.time) << "    "
           << (solve.converged ? "yes" : "no") << "\n"
           << scaling_text(solve);
  }
  if (!model.safety_trials.empty()) {
    out_ << heading("FOS (trials with the strength of joints divided by a factor)")
         << over_whole("card") << over_number("factor") << "    outcome  "
         << over_whole("steps") << over_number("ratio") << over_number("local")
         << over_whole("fastest") << over_number("speed") << over_number("moved")
         << "\n";
    for (const SafetyTrial& trial : model.safety_trials)
      out_ << whole(trial.search + 1) << number(trial.factor)
           << fmt::format("    {:<9}", describe(trial.outcome)) << whole(trial.steps)
           << number(trial.ratio) << number(trial.local) << whole(trial.block + 1)
           << number(trial.speed) << number(trial.moved) << "\n";
  }
  if (model.energy.kept) {
    out_ << heading("ENERGY");
    for (const quantities::EnergyQuantity& one : quantities::energy_quantities())
      line(one.label.c_str(), real(one.value(model.energy)));
  }
  flush();
}

}  // namespace blocks::output
