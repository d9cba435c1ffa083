#include "bundled_fonts.hpp"

#include <sys/auxv.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace blocks::apps {

void use_bundled_fonts() {
  // The kernel passes the path of the program, also where /proc is not mounted.
  const auto* path = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
  if (path == nullptr)
    return;
  std::error_code fault;
  const auto program = std::filesystem::canonical(path, fault);
  const auto settings = program.parent_path().parent_path() / "share/blocks/fonts.conf";
  constexpr int keep = 0;
  if (!fault && std::filesystem::exists(settings, fault))
    setenv("FONTCONFIG_FILE", settings.c_str(), keep);
}

}  // namespace blocks::apps
