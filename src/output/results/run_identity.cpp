// Reads the run and the deck of a results file without its frames.
#include <fmt/format.h>

#include <filesystem>

#include "files/file_access_guard.hpp"
#include "files/hdf5_handle.hpp"
#include "output/results/results.hpp"

namespace blocks::output {

std::string RunIdentity::deck_name() const {
  return fmt::format("{} '{}'", std::filesystem::path(deck_file).filename().string(),
                     title);
}

bool RunIdentity::same_deck(const RunIdentity& other) const {
  return deck_name() == other.deck_name() && deck_text == other.deck_text &&
         overrides == other.overrides && seed == other.seed;
}

std::string ResultsWriter::run_id_of(const std::string& path) {
  const files::FileAccessGuard in_hand("read", path);
  try {
    const hdf5::Handle file = hdf5::open_file(path, false);
    return hdf5::read_text(file.get(), "BLOCKS/run_id");
  } catch (const hdf5::Failure&) {
    return {};
  }
}

std::optional<RunIdentity> ResultsWriter::identity_of(const std::string& path) {
  const files::FileAccessGuard in_hand("read", path);
  try {
    const hdf5::Handle file = hdf5::open_file(path, false);
    const hdf5::Handle own = hdf5::open_group(file.get(), "BLOCKS");
    RunIdentity identity;
    identity.deck_file = hdf5::read_text(own.get(), "deck_file");
    identity.deck_text = hdf5::read_text(own.get(), "deck_text");
    identity.title = hdf5::read_text(own.get(), "title");
    identity.seed =
        static_cast<unsigned long long>(hdf5::read_attribute(own.get(), "seed"));
    if (hdf5::exists(own.get(), "overrides"))  // missing in files of earlier versions
      identity.overrides = hdf5::read_text(own.get(), "overrides");
    if (hdf5::exists(own.get(), "continues_run"))
      identity.continues_run = hdf5::read_text(own.get(), "continues_run");
    return identity;
  } catch (const hdf5::Failure&) {
    return {};
  }
}

}  // namespace blocks::output
