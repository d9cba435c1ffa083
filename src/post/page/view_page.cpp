#include "post/page/view_page.hpp"

#include <utility>

namespace blocks::post {

std::string view_page(const ViewData& data) {
  std::string meta;  // a title may hold </script>
  for (const char c : data.meta)
    meta += c == '<' ? "\\u003c" : std::string(1, c);
  const std::string form = view_html;
  std::string page;
  std::size_t at = 0;
  for (const auto& [place, text] :
       {std::pair<std::string, std::string>{"{{style}}", view_css},
        {"{{meta}}", meta},
        {"{{data}}", data.packed},
        {"{{script}}", view_js}}) {
    const std::size_t next = form.find(place, at);
    page += form.substr(at, next - at) + text;
    at = next + place.size();
  }
  return page + form.substr(at);
}

}  // namespace blocks::post
