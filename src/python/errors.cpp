#include "errors.hpp"

#include <pybind11/stl.h>

#include <algorithm>

#include "files/file_error.hpp"
#include "text.hpp"

namespace blocks::python {
namespace {

/// Returns a name of the module blocks.errors.
py::object from_errors(const char* name) {
  return py::module_::import("blocks.errors").attr(name);
}

void set(const py::object& type, const py::object& error) {
  PyErr_SetObject(type.ptr(), error.ptr());
}

/// Sets an exception that has diagnostics: DeckError or FileError.
void set_with_diagnostics(const char* name, const std::string& printed,
                          const std::vector<DeckMessage>& messages) {
  const py::object type = from_errors(name);
  set(type, type(text_of(printed), py::cast(messages)));
}

std::string line_of(const DeckMessage& message) {
  return "<Diagnostic " + message.file + ':' + std::to_string(message.line) + ':' +
         std::to_string(message.column) + ": " +
         (message.is_error ? "error: " : "warning: ") +
         (message.card.empty() ? "" : message.card + ": ") + message.message + '>';
}

}  // namespace

void raise(const char* name, const std::string& message) {
  const py::object type = from_errors(name);
  set(type, type(text_of(message)));
  throw py::error_already_set();
}

void raise(const char* name, const Messages& messages) {
  set_with_diagnostics(name, messages.printed, messages.of_deck);
  throw py::error_already_set();
}

bool Messages::has_errors() const {
  return std::any_of(of_deck.begin(), of_deck.end(),
                     [](const DeckMessage& message) { return message.is_error; });
}

void warn(const Messages& messages) {
  const py::object warn = from_errors("warn");
  for (const DeckMessage& message : messages.of_deck)
    if (!message.is_error)
      warn(text_of(message.printed), from_errors("DeckWarning"));
  for (const std::string& message : messages.of_run)
    warn(text_of(message), from_errors("RunWarning"));
}

void bind_errors(py::module_& module) {
  py::class_<DeckMessage> diagnostic(module, "Diagnostic",
                                     R"(An error or a warning about a deck.

str() gives it as the command line prints it, with the line of the deck and a caret.)");
  diagnostic
      .def_property_readonly(
          "severity",
          [](const DeckMessage& m) { return m.is_error ? "error" : "warning"; },
          "'error' or 'warning'")
      .def_readonly("line", &DeckMessage::line,
                    "line of the deck, from 1; 0: the deck as a whole")
      .def_readonly("column", &DeckMessage::column, "column of the line, from 1")
      .def("__str__", [](const DeckMessage& m) { return text_of(m.printed); })
      .def("__repr__", [](const DeckMessage& m) { return text_of(line_of(m)); })
      .def(py::pickle(
          [](const DeckMessage& m) {
            return py::make_tuple(m.is_error, py::bytes(m.file), m.line, m.column,
                                  py::bytes(m.card), py::bytes(m.message),
                                  py::bytes(m.hint), py::bytes(m.printed));
          },
          [](const py::tuple& state) {
            const auto text = [&](int i) { return state[i].cast<std::string>(); };
            return DeckMessage{state[0].cast<bool>(),
                               text(1),
                               state[2].cast<int>(),
                               state[3].cast<int>(),
                               text(4),
                               text(5),
                               text(6),
                               text(7)};
          }));
  const auto words = [&](const char* name, std::string DeckMessage::*member,
                         const char* help) {
    diagnostic.def_property_readonly(
        name, [member](const DeckMessage& m) { return text_of(m.*member); }, help);
  };
  words("file", &DeckMessage::file, "name of the deck");
  words("card", &DeckMessage::card, "name of the card at fault; empty: none");
  words("message", &DeckMessage::message, "what is wrong");
  words("hint", &DeckMessage::hint, "how to mend it; may be empty");

  py::register_exception_translator([](std::exception_ptr fault) {
    const auto set_as = [](const char* name, const std::exception& error) {
      const py::object type = from_errors(name);
      set(type, type(text_of(error.what())));
    };
    try {
      if (fault)
        std::rethrow_exception(fault);
    } catch (const DeckError& error) {
      set_with_diagnostics("DeckError", error.what(), error.messages());
    } catch (const UnsoundRun& error) {
      set_as("UnsoundRun", error);
    } catch (const files::FileError& error) {
      set_as("FileError", error);
    } catch (const std::out_of_range&) {
      throw;  // IndexError
    } catch (const std::logic_error& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
}

}  // namespace blocks::python
