#include "files/opened_file.hpp"

#include <unistd.h>

namespace blocks::files {

OpenedFile::~OpenedFile() {
  if (descriptor_ >= 0)
    ::close(descriptor_);
}

}  // namespace blocks::files
