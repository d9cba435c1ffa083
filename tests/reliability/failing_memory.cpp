// A library for LD_PRELOAD. The BLOCKS_FAIL_AT-th memory request of the program fails,
// and with BLOCKS_FAIL_ON all later ones fail, too. It counts operator new and calls of
// malloc from the program itself (those of Eigen) after main begins. Requests of
// libraries never fail. The file BLOCKS_COUNT has the number of requests when the
// program ends.
#include <dlfcn.h>
#include <link.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

bool in_main = false;
long requests = 0, fail_at = 0;
bool fail_on = false;
std::uintptr_t program_from = 0, program_to = 0;

int find_program(dl_phdr_info* info, std::size_t, void*) {
  for (int i = 0; i < info->dlpi_phnum; ++i)
    if (info->dlpi_phdr[i].p_type == PT_LOAD && (info->dlpi_phdr[i].p_flags & PF_X)) {
      program_from = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
      program_to = program_from + info->dlpi_phdr[i].p_memsz;
    }
  return 1;  // The program is the first object.
}

bool fails() {
  if (!in_main)
    return false;
  ++requests;
  return fail_at > 0 && (requests == fail_at || (fail_on && requests > fail_at));
}

void write_count() {
  in_main = false;
  if (std::FILE* file = std::fopen(std::getenv("BLOCKS_COUNT"), "w")) {
    std::fprintf(file, "%ld\n", requests);
    std::fclose(file);
  }
}

using Main = int (*)(int, char**, char**);
Main program_main = nullptr;

int counted_main(int argc, char** argv, char** environment) {
  dl_iterate_phdr(find_program, nullptr);
  fail_at = std::atol(std::getenv("BLOCKS_FAIL_AT"));
  fail_on = std::getenv("BLOCKS_FAIL_ON") != nullptr;
  std::atexit(write_count);
  in_main = true;
  return program_main(argc, argv, environment);
}

void* request(std::size_t size) {
  void* memory = fails() ? nullptr : std::malloc(size);
  if (memory == nullptr)
    throw std::bad_alloc();
  return memory;
}

void* request(std::size_t size, std::align_val_t align) {
  const auto step = static_cast<std::size_t>(align);
  void* memory =
      fails() ? nullptr : std::aligned_alloc(step, (size + step - 1) / step * step);
  if (memory == nullptr)
    throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return request(size); }
void* operator new[](std::size_t size) { return request(size); }
void* operator new(std::size_t size, std::align_val_t align) {
  return request(size, align);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

extern "C" {

void* __libc_malloc(std::size_t size);

void* malloc(std::size_t size) {
  const auto caller = reinterpret_cast<std::uintptr_t>(__builtin_return_address(0));
  if (in_main && caller >= program_from && caller < program_to && fails()) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_malloc(size);
}

int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*loader_fini)(), void* stack) {
  using Start = int(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  program_main = main;
  const bool is_shell = std::strcmp(program_invocation_short_name, "blocks") != 0;
  return reinterpret_cast<Start*>(dlsym(RTLD_NEXT, "__libc_start_main"))(
      is_shell ? main : counted_main, argc, argv, init, fini, loader_fini, stack);
}

}  // extern "C"
