// NumPy views of the columns of blocks, which stay valid whatever happens to the model.
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/blocks.hpp"

namespace blocks::python {

namespace py = pybind11;

/// The views of the blocks of one model. A view points to a column of the model, and
/// keeps a store alive, which is empty at first. Before the columns get other memory,
/// detach() moves them to the store; so the memory lives as long as the views, which
/// then keep their values. Create and detach views with the lock of Python, or while no
/// other thread can use the model.
class Views {
 public:
  /// Returns a read-only array over a column of doubles or whole numbers.
  template <class Number>
  py::array read_only(const Number* data, std::vector<py::ssize_t> shape) const {
    return make(py::dtype::of<Number>(), data, std::move(shape),
                new Holder{store_, nullptr});
  }
  /// Returns an array that may be written to.
  py::array writable(double* data, std::vector<py::ssize_t> shape) const {
    return make(py::dtype::of<double>(), data, std::move(shape),
                new Holder{store_, writer_});
  }

  /// Whether Python has views of the present columns.
  bool exist() const { return store_.use_count() > 1; }
  /// Whether Python has one that may be written to.
  bool exist_writable() const { return writer_.use_count() > 1; }

  /// Moves the columns to the views, if there are any. The blocks get a copy.
  void detach(Blocks& blocks) {
    if (!exist())
      return;
    Blocks copy = blocks;
    hand_over(blocks);
    blocks = std::move(copy);
  }
  /// The same at the end of the model, without a copy.
  void hand_over(Blocks& blocks) {
    if (exist())
      *store_ = std::move(blocks);
    store_ = std::make_shared<Blocks>();
    writer_ = std::make_shared<char>();
  }

 private:
  /// What a view keeps alive.
  struct Holder {
    std::shared_ptr<Blocks> store;
    std::shared_ptr<char> writer;  ///< null: it is read-only
  };
  static py::array make(const py::dtype& type, const void* data,
                        std::vector<py::ssize_t> shape, Holder* holder);

  std::shared_ptr<Blocks> store_ = std::make_shared<Blocks>();
  std::shared_ptr<char> writer_ = std::make_shared<char>();
};

}  // namespace blocks::python
