// Reads any bytes as a deck. The result has commands, or messages that can be shown.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "deck/free_field.hpp"
#include "deck/parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  blocks::deck::first_binary_byte(text);
  blocks::deck::Diagnostics told("fuzz", text);
  const auto deck = blocks::deck::parse("fuzz", text, told);
  const std::string messages = told.format_all();
  if (told.has_errors() ? messages.find("error: ") == std::string::npos
                        : deck.commands.empty())
    std::abort();
  return 0;
}
