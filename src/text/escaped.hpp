// Texts in XML and HTML.
#pragma once

#include <string>

namespace blocks::text {

/// Returns the text with &, <, > and double quotes as entities, for the content and the
/// attributes of elements.
std::string escaped(const std::string& text);

}  // namespace blocks::text
