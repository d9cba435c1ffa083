// The file starts with a seal of 512 bytes of plain text (HDF5's user block). It holds
// the type and format of the file and a hash over all the bytes that follow. The seal
// is verified before HDF5 opens the file, so that a damaged file is never partly read.
#include "output/checkpoint/checkpoint.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "files/file_access_guard.hpp"
#include "files/file_tools.hpp"
#include "files/fnv1a.hpp"
#include "files/hdf5_errors.hpp"
#include "output/checkpoint/checkpoint_fields.hpp"
#include "output/checkpoint/checkpoint_validation.hpp"
#include "output/checkpoint/model_archive.hpp"

namespace blocks::output {
namespace {

constexpr int format = checkpoint_format;
constexpr std::size_t seal_size = 512;
constexpr const char* magic = "BLOCKS checkpoint\n";

std::string seal(std::uint64_t bytes, const std::string& hash) {
  std::string text =
      fmt::format("{}format {}\nbytes {}\nfnv1a {}\n", magic, format, bytes, hash);
  text.resize(seal_size, '\0');
  return text;
}

/// The seal that matches the bytes after the first 512.
std::string seal_of(std::istream& file) {
  file.clear();
  file.seekg(seal_size);
  files::Fnv1a hash;
  std::uint64_t bytes = 0;
  std::vector<char> buffer(std::size_t{1} << 20);
  while (file) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    hash.add(buffer.data(), static_cast<std::size_t>(file.gcount()));
    bytes += static_cast<std::uint64_t>(file.gcount());
  }
  return seal(bytes, hash.text());
}

/// The size of the file according to its seal; that of the seal itself if it does not
/// tell.
std::uint64_t whole_size(const std::string& seal) {
  unsigned long long bytes = 0;
  const auto at = seal.find("\nbytes ");
  if (at != std::string::npos)
    std::sscanf(seal.c_str() + at, "\nbytes %llu", &bytes);
  return seal_size + bytes;
}

/// Writes the seal. `meant` is the file name for messages.
void set_seal(const std::string& path, const std::string& meant) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  const std::string text = seal_of(file);
  file.clear();
  file.seekp(0);
  file.write(text.data(), seal_size);
  file.close();
  if (!file)
    files::throw_errno("write", meant);
}

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  std::string message = "cannot read " + path + ": " + reason;
  std::error_code ignored;
  if (const std::string previous = path + ".prev";
      std::filesystem::exists(previous, ignored))
    message += "; the previous checkpoint is " + previous;
  throw files::FileError(message);
}

void verify_seal(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    refuse(path, "it is a folder");
  if (std::filesystem::exists(path, ignored) &&
      !std::filesystem::is_regular_file(path, ignored))
    refuse(path, "it is not a regular file");  // a pipe would block
  std::ifstream file(path, std::ios::binary);
  if (!file)
    refuse(path, std::generic_category().message(errno));
  std::string head(seal_size, '\0');
  file.read(head.data(), seal_size);
  if (!head.starts_with(magic))
    refuse(path, "it is not a checkpoint of BLOCKS");
  if (int found = 0;
      std::sscanf(head.c_str() + std::strlen(magic), "format %d", &found) == 1 &&
      found != format)
    refuse(path, fmt::format("{} version of BLOCKS wrote it (format {}, this version "
                             "reads format {})",
                             found > format ? "a newer" : "an older", found, format));
  const std::uint64_t size = std::filesystem::file_size(path, ignored);
  if (size < whole_size(head))
    refuse(path, hdf5::truncated(size, whole_size(head)));
  if (head != seal_of(file))
    refuse(path, "it is damaged: its checksum is wrong");
}

/// Gives the previous checkpoint a second name first, so that `path` exists at every
/// moment.
void keep_previous(const std::string& path) {
  const std::string previous = path + ".prev";
  std::error_code fault;
  if (!std::filesystem::exists(path, fault))
    return;
  files::expect_replaceable(previous);
  std::filesystem::remove(previous, fault);
  std::filesystem::create_hard_link(path, previous, fault);
  if (fault)  // the file system has no hard links
    files::move_file(path, previous);
}

}  // namespace

void write_checkpoint(const std::string& path, const Model& model,
                      const CheckpointInfo& info) {
  files::TemporaryFile temporary(path);
  files::with_file_errors("write", path, [&] {
    hdf5::Handle file = hdf5::create_file(temporary.path(), seal_size);
    hdf5::write_text_attribute(file.get(), "magic", "BLOCKS checkpoint");
    hdf5::write_attribute(file.get(), "format", format);
    SavingArchive archive(file.get());
    visit_checkpoint(model, info, archive);
    hdf5::check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL));
    file.close();
  });
  set_seal(temporary.path(), path);
  files::sync_file(temporary.path(), path);
  keep_previous(path);
  temporary.take_name();
  files::sync_folder_of(path);
}

Model read_checkpoint(const std::string& path, CheckpointInfo& info) {
  verify_seal(path);
  const files::FileAccessGuard in_hand("read", path);
  try {
    const hdf5::Handle file = hdf5::open_file(path, false);
    Model model;
    LoadingArchive archive(file.get());
    visit_checkpoint(model, info, archive);
    validate_checkpoint(model, info);
    return model;
  } catch (const hdf5::Failure& failure) {
    refuse(path, failure.what());
  }
}

}  // namespace blocks::output
