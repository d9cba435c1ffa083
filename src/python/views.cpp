#include "views.hpp"

namespace blocks::python {

py::array Views::make(const py::dtype& type, const void* data,
                      std::vector<py::ssize_t> shape, Holder* holder) {
  const bool may_write = holder->writer != nullptr;
  const py::capsule base(holder, [](void* held) { delete static_cast<Holder*>(held); });
  py::array view(type, std::move(shape), {}, data, base);
  if (!may_write)
    view.attr("setflags")(py::arg("write") = false);
  return view;
}

}  // namespace blocks::python
