#include "files/ordered_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <new>
#include <tuple>
#include <utility>
#include <vector>

#include "files/hdf5_handle.hpp"

namespace blocks::hdf5 {
namespace {

using Bytes = std::vector<unsigned char>;

constexpr herr_t failed = -1;

/// Pushes the system's error message in the format of HDF5's own driver.
herr_t fail(hid_t what) {
  H5Epush2(H5E_DEFAULT, __FILE__, "ordered_file", __LINE__, H5E_ERR_CLS, H5E_IO, what,
           "error message = '%s'", std::strerror(errno));
  return failed;
}

struct OrderedFile {
  H5FD_t shared;  ///< HDF5's part; must come first
  int file = -1;
  haddr_t end_allocated = 0, end_written = 0;
  haddr_t end_known = 0;  ///< end of the parts that readers may refer to
  std::map<haddr_t, Bytes>* waiting = nullptr;  ///< metadata not yet in the file
  bool lost = false;    ///< a write failed; nothing more is written
  bool untold = false;  ///< the failure has not been reported
};

/// HDF5 is written in C, so no exception may pass through it. If memory runs out, the
/// published part of the file stays unchanged. The next flush reports the failure,
/// because HDF5 cannot close a file that rejects its metadata.
template <class Action> herr_t without_throwing(OrderedFile& file, Action&& action) {
  try {
    return action();
  } catch (const std::bad_alloc&) {
    file.untold = file.untold || !file.lost;
    file.lost = true;
    return 0;
  }
}

OrderedFile& ordered(H5FD_t* file) { return *reinterpret_cast<OrderedFile*>(file); }
const OrderedFile& ordered(const H5FD_t* file) {
  return *reinterpret_cast<const OrderedFile*>(file);
}

bool put(OrderedFile& to, haddr_t at, const unsigned char* bytes, std::size_t size) {
  to.end_written = std::max<haddr_t>(to.end_written, at + size);
  while (size > 0) {
    const ssize_t done = ::pwrite(to.file, bytes, size, static_cast<off_t>(at));
    if (done < 0 && errno == EINTR)
      continue;
    if (done <= 0) {
      to.lost = true;
      return false;
    }
    at += static_cast<haddr_t>(done);
    bytes += done;
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

/// Removes [at, at + size) from the waiting metadata; parts outside that range remain.
void remove_range(std::map<haddr_t, Bytes>& waiting, haddr_t at, std::size_t size) {
  auto run = waiting.upper_bound(at);
  if (run != waiting.begin())
    --run;
  const haddr_t end = at + size;
  while (run != waiting.end() && run->first < end) {
    const haddr_t from = run->first, to = from + run->second.size();
    if (to <= at) {
      ++run;
      continue;
    }
    const Bytes old = std::move(run->second);
    run = waiting.erase(run);
    if (from < at)
      waiting.emplace(from, Bytes(old.begin(), old.begin() + (at - from)));
    if (to > end)
      run = waiting.emplace(end, Bytes(old.begin() + (end - from), old.end())).first;
  }
}

bool is_superblock(const Bytes& bytes) {
  return bytes.size() > 4 && std::memcmp(bytes.data(), "\x89HDF", 4) == 0;
}

/// The height of a B-tree node above the leaves; 0 for everything else.
int height(const Bytes& bytes) {
  constexpr std::size_t level = 5;
  return bytes.size() > level && std::memcmp(bytes.data(), "TREE", 4) == 0
             ? bytes[level]
             : 0;
}

/// Writes the waiting metadata. New space comes first, because nothing refers to it.
/// The superblock follows, because it holds the length of the file. B-tree nodes come
/// before the nodes below them: a split moves entries to a new node that only its
/// parent refers to.
bool publish(OrderedFile& file) {
  if (file.lost)
    return true;
  std::vector<std::pair<haddr_t, const Bytes*>> runs;
  for (const auto& [at, bytes] : *file.waiting)
    runs.emplace_back(at, &bytes);
  const auto turn = [&](const auto& run) {
    return std::tuple(run.first < file.end_known, !is_superblock(*run.second),
                      -height(*run.second), run.first);
  };
  std::sort(runs.begin(), runs.end(),
            [&](const auto& a, const auto& b) { return turn(a) < turn(b); });
  for (const auto& [at, bytes] : runs) {
    if (is_superblock(*bytes) && file.end_written < file.end_allocated) {
      if (::ftruncate(file.file, static_cast<off_t>(file.end_allocated)) != 0) {
        file.lost = true;
        return false;
      }
      file.end_written = file.end_allocated;
    }
    if (!put(file, at, bytes->data(), bytes->size()))
      return false;
  }
  file.waiting->clear();
  file.end_known = file.end_allocated;
  return true;
}

H5FD_t* open_file_for(const char* name, unsigned flags, hid_t, haddr_t) {
  const int mode = ((flags & H5F_ACC_RDWR) != 0 ? O_RDWR : O_RDONLY) |
                   ((flags & H5F_ACC_TRUNC) != 0 ? O_TRUNC : 0) |
                   ((flags & H5F_ACC_CREAT) != 0 ? O_CREAT : 0) |
                   ((flags & H5F_ACC_EXCL) != 0 ? O_EXCL : 0) | O_CLOEXEC;
  const int descriptor = ::open(name, mode, 0666);
  if (descriptor < 0) {
    fail(H5E_CANTOPENFILE);
    return nullptr;
  }
  auto* file = new (std::nothrow) OrderedFile{};
  auto* waiting = new (std::nothrow) std::map<haddr_t, Bytes>;
  if (file == nullptr || waiting == nullptr) {
    ::close(descriptor);
    delete file;
    delete waiting;
    errno = ENOMEM;
    fail(H5E_CANTOPENFILE);
    return nullptr;
  }
  file->file = descriptor;
  file->end_written = static_cast<haddr_t>(::lseek(descriptor, 0, SEEK_END));
  file->end_known = file->end_written;
  file->waiting = waiting;
  return &file->shared;
}

herr_t close_file(H5FD_t* shared) {
  OrderedFile& file = ordered(shared);
  without_throwing(file, [&] { return publish(file) ? 0 : failed; });
  ::close(file.file);
  delete file.waiting;
  delete &file;
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  *flags = 0;  // each structure is written separately
#ifdef H5FD_FEAT_DEFAULT_VFD_COMPATIBLE
  *flags |= H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
#endif
  return 0;
}

haddr_t get_eoa(const H5FD_t* file, H5FD_mem_t) { return ordered(file).end_allocated; }

herr_t set_eoa(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  ordered(file).end_allocated = end;
  return 0;
}

haddr_t get_eof(const H5FD_t* shared, H5FD_mem_t) {
  const OrderedFile& file = ordered(shared);
  haddr_t end = file.end_written;
  if (!file.waiting->empty()) {
    const auto& [at, bytes] = *file.waiting->rbegin();
    end = std::max<haddr_t>(end, at + bytes.size());
  }
  return end;
}

herr_t read(H5FD_t* shared, H5FD_mem_t, hid_t, haddr_t at, std::size_t size,
            void* into) {
  const OrderedFile& file = ordered(shared);
  auto* bytes = static_cast<unsigned char*>(into);
  for (std::size_t done = 0; done < size;) {
    const ssize_t got =
        ::pread(file.file, bytes + done, size - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR)
      continue;
    if (got < 0)
      return fail(H5E_READERROR);
    if (got == 0) {  // never written
      std::memset(bytes + done, 0, size - done);
      break;
    }
    done += static_cast<std::size_t>(got);
  }
  auto run = file.waiting->upper_bound(at);
  if (run != file.waiting->begin())
    --run;
  for (; run != file.waiting->end() && run->first < at + size; ++run) {
    const haddr_t from = std::max(at, run->first),
                  to = std::min<haddr_t>(at + size, run->first + run->second.size());
    if (from < to)
      std::memcpy(bytes + (from - at), run->second.data() + (from - run->first),
                  to - from);
  }
  return 0;
}

/// Raw data are written at once. Values of published frames are only rewritten
/// unchanged.
herr_t write(H5FD_t* shared, H5FD_mem_t type, hid_t, haddr_t at, std::size_t size,
             const void* from) {
  OrderedFile& file = ordered(shared);
  const auto* bytes = static_cast<const unsigned char*>(from);
  return without_throwing(file, [&] {
    remove_range(*file.waiting, at, size);
    if (type != H5FD_MEM_DRAW) {
      file.waiting->emplace(at, Bytes(bytes, bytes + size));
      return 0;
    }
    return file.lost || put(file, at, bytes, size) ? 0 : fail(H5E_WRITEERROR);
  });
}

/// Errors are not reported while closing, because HDF5 would then keep the file half
/// closed. Callers that need them flush first.
herr_t flush(H5FD_t* shared, hid_t, hbool_t closing) {
  OrderedFile& file = ordered(shared);
  const herr_t done =
      without_throwing(file, [&] { return publish(file) ? 0 : fail(H5E_WRITEERROR); });
  if (closing)
    return 0;
  if (std::exchange(file.untold, false)) {
    errno = ENOMEM;
    return fail(H5E_WRITEERROR);
  }
  return done;
}

herr_t truncate(H5FD_t* shared, hid_t, hbool_t closing) {
  OrderedFile& file = ordered(shared);
  const auto published = [&] { return publish(file) ? 0 : failed; };
  if (closing && without_throwing(file, published) == 0 && !file.lost &&
      ::ftruncate(file.file, static_cast<off_t>(file.end_allocated)) == 0)
    file.end_written = file.end_allocated;
  return 0;
}

hid_t driver() {
  static const H5FD_class_t functions = [] {
    H5FD_class_t made{};
#if H5_VERSION_GE(1, 13, 0)
    made.version = H5FD_CLASS_VERSION;
    made.value = static_cast<H5FD_class_value_t>(513);
#endif
    made.name = "blocks_ordered";
    made.maxaddr = HADDR_MAX;
    made.fc_degree = H5F_CLOSE_WEAK;
    made.open = open_file_for;
    made.close = close_file;
    made.query = query;
    made.get_eoa = get_eoa;
    made.set_eoa = set_eoa;
    made.get_eof = get_eof;
    made.read = read;
    made.write = write;
    made.flush = flush;
    made.truncate = truncate;
    const H5FD_mem_t kinds[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(kinds), std::end(kinds), made.fl_map);
    return made;
  }();
  static const hid_t id = check(H5FDregister(&functions));
  return id;
}

}  // namespace

void write_in_order(hid_t file_access) {
  check(H5Pset_driver(file_access, driver(), nullptr));
}

}  // namespace blocks::hdf5
