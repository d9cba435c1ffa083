// Results files with forged indices, and with datasets that are links or are stored in
// other files. Every command refuses them with exit code 5 and the name of the dataset.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <climits>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

/// A block on a fixed one.
const std::string deck = preliminary() + rectangle(0, 0, 1, 1, true) +
                         rectangle(0, 1, 1, 2) +
                         "GRAVITY, 0, -10\nPLOTS, 0.002\nCYCLE, 10\n";

const std::vector<std::string> commands = {
    "why a.vtkhdf -b 1 -b 2", "view a.vtkhdf -o a.html", "export a.vtkhdf -o a.csv",
    "export a.vtkhdf -o a.pvd", "plot a.vtkhdf --forces -o a.png"};

/// Runs the command for at most 20 s.
Outcome run_limited(const std::string& command, const TemporaryFolder& folder) {
  folder.write("limited.sh", "exec timeout 20 " BLOCKS_PROGRAM " " + command + "\n");
  const int status = std::system(
      ("cd '" + folder.path().string() + "' && sh limited.sh > out 2> err < /dev/null")
          .c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, slurp(folder / "out"),
          slurp(folder / "err")};
}

class Forged : public ::testing::Test {
 protected:
  Forged() {
    folder_.write("a.deck", deck);
    EXPECT_EQ(blocks("run a.deck -q", folder_.path()).code, 0);
    fs::rename(folder_ / "a.vtkhdf", folder_ / "sound");
    EXPECT_EQ(::mkfifo((folder_ / "fifo").c_str(), 0600), 0);
    folder_.write("secret", std::string(100000, 'x'));
  }

  /// Copies the sound file to a.vtkhdf, and calls forge(file) with it.
  template <class Forge> void forge(Forge&& forge) {
    fs::copy_file(folder_ / "sound", folder_ / "a.vtkhdf",
                  fs::copy_options::overwrite_existing);
    const hid_t file =
        H5Fopen((folder_ / "a.vtkhdf").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    forge(file);
    ASSERT_GE(H5Fclose(file), 0);
  }

  void expect_refused(const std::string& command, const std::string& name) {
    const Outcome end = run_limited(command, folder_);
    EXPECT_EQ(end.code, 5) << command << ", " << name << ": " << end.err;
    EXPECT_THAT(end.err, HasSubstr("blocks: error: cannot read a.vtkhdf: "));
    EXPECT_THAT(end.err, HasSubstr(name)) << command;
  }

  TemporaryFolder folder_;
};

TEST_F(Forged, IndicesOfContactsAreRefused) {
  for (const std::string& command : commands) {
    for (const char* name : {"CornerBlock", "Corner", "EdgeBlock", "Edge"})
      for (const int value : {INT_MIN, -1, 0, 5, INT_MAX}) {
        if (name == std::string("EdgeBlock") && value == 0)
          continue;  // a symmetry plane
        forge([&](hid_t file) {
          const hid_t set = H5Dopen2(
              file, (std::string("BLOCKS/contacts/") + name).c_str(), H5P_DEFAULT);
          const hid_t space = H5Dget_space(set);
          const auto n = H5Sget_simple_extent_npoints(space);
          ASSERT_GT(n, 0);
          const std::vector<int> values(static_cast<std::size_t>(n), value);
          ASSERT_GE(H5Dwrite(set, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                             values.data()),
                    0);
          H5Sclose(space);
          H5Dclose(set);
        });
        expect_refused(command, std::string("contacts/") + name + " is out of range");
      }
  }
}

/// What a name of the file is replaced by.
enum class Other { external_storage, fifo, external_link, soft_link, virtual_dataset };

void replace(hid_t file, const std::string& path, Other other) {
  const hid_t set = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
  ASSERT_GE(set, 0) << path;
  const hid_t type = H5Dget_type(set), space = H5Dget_space(set);
  hsize_t size[2] = {1, 1};
  const int rank = H5Sget_simple_extent_dims(space, size, nullptr);
  const hid_t fixed =
      rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(rank, size, nullptr);
  ASSERT_GE(H5Ldelete(file, path.c_str(), H5P_DEFAULT), 0);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  switch (other) {
  case Other::external_storage:
  case Other::fifo:
    H5Pset_external(creation, other == Other::fifo ? "fifo" : "secret", 0,
                    H5F_UNLIMITED);
    break;
  case Other::virtual_dataset:
    H5Pset_virtual(creation, fixed, "fifo", "there", fixed);
    break;
  case Other::external_link:
    ASSERT_GE(H5Lcreate_external("fifo", "/there", file, path.c_str(), H5P_DEFAULT,
                                 H5P_DEFAULT),
              0);
    break;
  case Other::soft_link:
    ASSERT_GE(
        H5Lcreate_soft("/BLOCKS/title", file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        0);
    break;
  }
  if (other != Other::external_link && other != Other::soft_link) {
    const hid_t made =
        H5Dcreate2(file, path.c_str(), type, fixed, H5P_DEFAULT, creation, H5P_DEFAULT);
    ASSERT_GE(made, 0) << path;
    H5Dclose(made);
  }
  H5Pclose(creation);
  H5Sclose(fixed);
  H5Sclose(space);
  H5Tclose(type);
  H5Dclose(set);
}

TEST_F(Forged, OtherFilesAreNotRead) {
  const std::vector<std::pair<std::string, std::string>> datasets = {
      {"VTKHDF/CellData/", "Material"}, {"VTKHDF/", "Points"},
      {"VTKHDF/", "Offsets"},           {"VTKHDF/Steps/", "Values"},
      {"BLOCKS/contacts/", "Corner"},   {"VTKHDF/Steps/CellDataOffsets/", "Material"}};
  for (const auto& [group, name] : datasets)
    for (const Other other :
         {Other::external_storage, Other::fifo, Other::external_link, Other::soft_link,
          Other::virtual_dataset}) {
      forge([&](hid_t file) { replace(file, group + name, other); });
      for (const std::string& command : commands)
        expect_refused(command, name);
    }
  // A run reads the deck of older results.
  for (const Other other : {Other::external_link, Other::soft_link}) {
    forge([&](hid_t file) { replace(file, "BLOCKS/deck_text", other); });
    EXPECT_EQ(run_limited("run a.deck -q", folder_).code, 0);
  }
}

TEST_F(Forged, GroupsOfOtherFilesAreNotRead) {
  for (const char* group : {"VTKHDF", "BLOCKS", "VTKHDF/Steps", "BLOCKS/contacts"}) {
    forge([&](hid_t file) {
      ASSERT_GE(H5Ldelete(file, group, H5P_DEFAULT), 0);
      ASSERT_GE(
          H5Lcreate_external("fifo", "/there", file, group, H5P_DEFAULT, H5P_DEFAULT),
          0);
    });
    const std::string name = group;
    for (const std::string& command : commands)
      expect_refused(command, name.substr(name.find('/') + 1));
  }
}

TEST_F(Forged, APipeIsRefused) {
  fs::rename(folder_ / "fifo", folder_ / "a.vtkhdf");
  for (const std::string& command : commands)
    expect_refused(command, "it is not a regular file");
}

}  // namespace
}  // namespace blocks::testing
