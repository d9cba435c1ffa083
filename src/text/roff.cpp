#include "text/roff.hpp"

#include <fmt/format.h>

#include "text/capitals.hpp"

namespace blocks::text::roff {

std::string text(std::string_view words) {
  std::string out;
  for (const char c : words) {
    const bool starts_line = out.empty() || out.back() == '\n';
    switch (c) {
    case '\\':
      out += "\\e";
      break;
    case '-':  // a minus sign, which can be copied, not a hyphen
      out += "\\-";
      break;
    case '`':
      out += "\\(ga";
      break;
    case '^':
      out += "\\(ha";
      break;
    case '~':
      out += "\\(ti";
      break;
    case '.':
    case '\'':
      out += starts_line ? "\\&" : "";
      out += c;
      break;
    default:
      out += c;
    }
  }
  return out;
}

std::string bold(std::string_view words) { return "\\fB" + text(words) + "\\fR"; }
std::string italic(std::string_view words) { return "\\fI" + text(words) + "\\fR"; }

std::string head(std::string_view name, int section, std::string_view version,
                 std::string_view volume, std::string_view meaning) {
  return fmt::format(
      ".TH {} {} \"\" \"BLOCKS {}\" \"{}\"\n.nh\n.ad l\n.SH NAME\n{} \\- {}\n",
      capitals(name), section, version, volume, text(name), text(meaning));
}

std::string section(std::string_view title) {
  return fmt::format(".SH {}\n", capitals(title));
}
std::string subsection(std::string_view title) {
  return fmt::format(".SS {}\n", text(title));
}
std::string paragraph(std::string_view words) {
  return fmt::format(".PP\n{}\n", text(words));
}
std::string item(std::string_view term, std::string_view meaning) {
  return fmt::format(".TP\n{}\n{}\n", term, text(meaning));
}
std::string example(std::string_view lines) {
  return fmt::format(".PP\n.RS 4\n.EX\n{}\n.EE\n.RE\n", text(lines));
}

}  // namespace blocks::text::roff
