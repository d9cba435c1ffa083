#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "files/file_error.hpp"
#include "files/name_lock.hpp"
#include "files/whole_file.hpp"
#include "post/export/time_series.hpp"
#include "post/export/vtu_file.hpp"
#include "post/read/crack_tracker.hpp"
#include "post/read/frame_quantity.hpp"
#include "text/escaped.hpp"

namespace blocks::post {
namespace {

namespace fs = std::filesystem;

std::vector<double> numbers(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}
std::vector<double> tensors(const Eigen::Matrix4Xd& values) {
  return {values.data(), values.data() + values.size()};
}

VtuGrid block_grid(const Frame& now, const CrackedBlocks& cracked) {
  const Frame& first = cracked.first;
  VtuGrid grid;
  Eigen::Index corners = 0;
  for (const auto& outline : now.outlines) {
    corners += static_cast<Eigen::Index>(outline.size());
    grid.ends.push_back(corners);
  }
  grid.points.resize(2, corners);
  for (Eigen::Index at = 0; const auto& outline : now.outlines)
    for (const Eigen::Vector2d& corner : outline) {
      grid.connectivity.push_back(at);
      grid.points.col(at++) = corner;
    }
  Eigen::Matrix2Xd moved(2, now.size());
  moved.row(0) = quantity("dx", now, first).values.transpose();
  moved.row(1) = quantity("dy", now, first).values.transpose();
  grid.cell_data = {{"BlockNumber", 1, now.number},
                    {"Material", 1, now.material},
                    {"Fixed", 1, now.fixed},
                    {"Area", 1, numbers(now.area)},
                    {"Mass", 1, numbers(now.mass)},
                    {"Inertia", 1, numbers(now.inertia)},
                    {"Centroid", 3, in_space(now.centroid)},
                    {"Displacement", 3, in_space(moved)},
                    {"Velocity", 3, in_space(now.velocity)},
                    {"Force", 3, in_space(now.force)},
                    {"Angle", 1, numbers(now.angle)},
                    {"Spin", 1, numbers(now.spin)},
                    {"Moment", 1, numbers(now.moment)},
                    {"Stress", 4, tensors(now.stress)},
                    {"AppliedStress", 4, tensors(now.applied)},
                    {"StrainRate", 4, tensors(now.strain_rate)}};
  if (!now.parent.empty())
    grid.cell_data.push_back({"Parent", 1, now.parent});
  return grid;
}

VtuGrid contact_grid(const FrameContacts& contacts) {
  VtuGrid grid;
  grid.cell_type = 1;
  grid.points = contacts.point;
  for (int i = 0; i < contacts.size(); ++i) {
    grid.connectivity.push_back(i);
    grid.ends.push_back(i + 1);
  }
  grid.cell_data = {{"CornerBlock", 1, contacts.corner_block},
                    {"Corner", 1, contacts.corner},
                    {"EdgeBlock", 1, contacts.edge_block},
                    {"Edge", 1, contacts.edge},
                    {"Normal", 3, in_space(contacts.normal)},
                    {"Force", 3, in_space(contacts.force())},
                    {"NormalForce", 1, numbers(contacts.normal_force)},
                    {"ShearForce", 1, numbers(contacts.shear_force)},
                    {"Overlap", 1, numbers(contacts.overlap)}};
  if (!contacts.states.empty())
    each_law_field([&]<class Member>(const LawField& field, Member LawState::*member) {
      std::vector<ResultsType<Member>> all;
      for (const LawState& state : contacts.states)
        all.push_back(state.*member);
      grid.cell_data.push_back({field.column, 1, std::move(all)});
    });
  return grid;
}

/// Whether write_pvd() gives files such names: blocks_07.vtu, contacts_07.vtu.
bool is_piece(const fs::path& file) {
  const std::string name = file.filename().string();
  const auto digits = name.find_first_of("0123456789");
  const std::string kind = name.substr(0, digits);
  return (kind == "blocks_" || kind == "contacts_") &&
         name.find_first_not_of("0123456789", digits) + 4 == name.size() &&
         name.ends_with(".vtu");
}

/// Deletes a folder of .vtu files, but only the files in it that write_pvd() has
/// written.
void remove_pieces(const fs::path& folder) {
  std::error_code fault;
  if (!fs::is_directory(fs::symlink_status(folder, fault)))
    return;
  for (const auto& entry : fs::directory_iterator(folder, fault))
    if (is_piece(entry.path()))
      fs::remove(entry.path(), fault);
  fs::remove(folder, fault);
}

/// Deletes such a folder. Throws files::FileError if the name is still taken.
void remove_older(const fs::path& folder, const fs::path& meant) {
  remove_pieces(folder);
  std::error_code fault;
  if (fs::exists(fs::symlink_status(folder, fault)))
    throw files::FileError(fmt::format("cannot write {}: {} contains other files",
                                       meant.string(), folder.string()));
}

void rename_folder(const fs::path& from, const fs::path& to) {
  std::error_code fault;
  fs::rename(from, to, fault);
  if (fault)
    throw files::FileError("cannot write " + to.string() + ": " + fault.message());
}

/// A folder of .vtu files that gets its name when it is complete. The destructor
/// removes it unless it has got its name.
class PieceFolder {
 public:
  /// Throws files::FileError.
  explicit PieceFolder(fs::path name)
      : name_(std::move(name)), path_(name_.string() + ".tmp") {
    remove_older(path_, name_);  // a killed program may have left it
    std::error_code fault;
    if (!fs::create_directory(path_, fault))
      throw files::FileError("cannot write " + name_.string() + ": " + fault.message());
  }
  ~PieceFolder() { remove_pieces(path_); }
  PieceFolder(const PieceFolder&) = delete;
  PieceFolder& operator=(const PieceFolder&) = delete;

  const fs::path& path() const { return path_; }
  /// Renames the folder; an older one gets the ending .bak. Throws files::FileError.
  void take_name() {
    std::error_code fault;
    if (fs::exists(fs::symlink_status(name_, fault))) {
      const fs::path aside = name_.string() + ".bak";
      remove_older(aside, name_);
      rename_folder(name_, aside);
    }
    rename_folder(path_, name_);
  }

 private:
  fs::path name_, path_;
};

/// A .pvd file, which lists the .vtu file of each time.
class Collection {
 public:
  void add(double time, const std::string& file) {
    text_ +=
        fmt::format("<DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n",
                    time, text::escaped(file));
  }
  void write(const std::string& path) const {
    files::WholeFile file(path);
    file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
            "byte_order=\"LittleEndian\">\n<Collection>\n"
         << text_ << "</Collection>\n</VTKFile>\n";
    file.close();
  }

 private:
  std::string text_;
};

}  // namespace

SeriesFiles write_pvd(const std::string& path, const ResultsReader& results,
                      const std::vector<long>& frames,
                      const std::function<void()>& may_stop) {
  const std::string name = fs::path(path).replace_extension().string();
  const fs::path folder = name + "_vtu";
  const files::NameLock lock(folder.string(), path);
  PieceFolder pieces(folder);
  SeriesFiles files{{path, name + "_contacts.pvd"}};
  Collection blocks, contacts;
  ResultsTracker tracker(results);
  const auto digits = std::to_string(frames.size()).size();
  const auto put = [&](VtuGrid grid, const Frame& now, const char* kind, std::size_t k,
                       Collection& collection) {
    const std::string piece = fmt::format("{}_{:0{}}.vtu", kind, k, digits);
    grid.time = now.time;
    grid.step = now.step;
    write_vtu((pieces.path() / piece).string(), grid);
    collection.add(now.time, folder.filename().string() + "/" + piece);
  };
  for (std::size_t k = 0; k < frames.size(); ++k) {
    may_stop();
    const Frame now = results.frame(frames[k]);
    const FrameContacts acting = results.contacts(frames[k]);
    put(block_grid(now, tracker.at(frames[k], now)), now, "blocks", k, blocks);
    put(contact_grid(acting), now, "contacts", k, contacts);
    files.blocks += now.size();
    files.contacts += acting.size();
  }
  pieces.take_name();
  blocks.write(files.names[0]);
  contacts.write(files.names[1]);
  return files;
}

}  // namespace blocks::post
