// Text of decks, whose encoding is not known.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace blocks::python {

/// Returns a str. Bytes that are not UTF-8 become replacement characters.
inline pybind11::str text_of(const std::string& bytes) {
  return pybind11::reinterpret_steal<pybind11::str>(PyUnicode_DecodeUTF8(
      bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace"));
}

}  // namespace blocks::python
