// blocks.run and blocks.check: a whole deck, as the command line runs and checks it.
#include "run/run.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "errors.hpp"
#include "files/file_tools.hpp"
#include "library/deck_messages.hpp"
#include "model/words/certificate_text.hpp"
#include "names.hpp"
#include "run/reports/check_report.hpp"
#include "run/support/interrupt.hpp"
#include "selectors.hpp"
#include "signal_watch.hpp"
#include "text.hpp"

namespace blocks::python {
namespace {

/// Lets Python handle signals while a run is at work. Keeps what a handler raises.
class OwnSignals {
 public:
  /// Whether the run has to stop.
  bool stops() {
    if (raised_)
      return true;
    try {
      watch_();
    } catch (const py::error_already_set&) {
      raised_ = std::current_exception();
    }
    return raised_ != nullptr;
  }
  void rethrow() const {
    if (raised_)
      std::rethrow_exception(raised_);
  }

 private:
  std::function<void()> watch_ = signal_watch();
  std::exception_ptr raised_;
};

run::RunOptions options_of(const std::string& deck, std::optional<std::string> text,
                           std::optional<std::uint64_t> seed,
                           const std::vector<std::string>& sets) {
  run::RunOptions options;
  options.deck = deck;
  options.text = std::move(text);
  options.seed = seed;
  for (const std::string& set : sets) {
    const auto override = deck::parse_override(set);
    if (!override)
      throw py::value_error("set: expected CARD.field or CARD[2].field, found '" + set +
                            "'");
    options.overrides.push_back(*override);
  }
  return options;
}

/// Executes work() as a command does, without the lock of Python. Raises DeckError or
/// FileError for errors in the deck. Returns an exit code.
template <class Work> int with_messages(run::RunOptions& options, const Work& work) {
  Messages messages;
  options.tell = [&](const deck::Diagnostics& diagnostics) {
    messages.printed = diagnostics.format_all();
    messages.of_deck = library::messages_of(diagnostics);
  };
  options.warn = [&](const std::string& message) {
    messages.of_run.push_back(message);
  };
  OwnSignals signals;
  int code = 0;
  {
    const py::gil_scoped_release released;
    const run::InterruptPoll poll([&] { return signals.stops(); });
    code = work();
  }
  signals.rethrow();
  if (messages.has_errors() && code != run::done)
    raise(code == run::file_error ? "FileError" : "DeckError", messages);
  warn(messages);
  return code;
}

/// Throws py::value_error if a value is not one that the command line would take.
void expect(bool holds, const std::string& what) {
  if (!holds)
    throw py::value_error(what);
}

int run_deck(const std::string& deck, std::optional<std::string> text,
             const std::string& out, std::optional<std::uint64_t> seed,
             const std::vector<std::string>& sets, int threads,
             std::optional<double> until, std::optional<std::string> restart,
             double time_limit, long audit, bool quiet) {
  expect(threads >= 0 && threads <= 1024, "threads is not in range 0 to 1024");
  expect(!until || (*until > 0.0 && std::isfinite(*until)), "until is not above 0");
  expect(time_limit >= 0.0 && std::isfinite(time_limit), "time_limit is below 0");
  expect(audit >= 0, "audit is below 0");
  run::RunOptions options = options_of(deck, std::move(text), seed, sets);
  options.output = out;
  options.threads = threads;
  options.until = until;
  options.restart = std::move(restart);
  options.time_limit = time_limit;
  options.audit_every = audit;
  options.quiet = quiet;
  return with_messages(options, [&] { return run::run_deck(options); });
}

/// The blocks of a deck before its first motion, with their certificate.
struct Checked {
  run::CheckedDeck deck;
  std::string report() const {
    std::string text = run::check_report(deck.file, deck.model, deck.certificate);
    for (const std::string& note : deck.notes)
      text += note + '\n';
    return text;
  }
};

std::shared_ptr<Checked> check_deck(const std::string& deck,
                                    std::optional<std::string> text,
                                    std::optional<std::uint64_t> seed,
                                    const std::vector<std::string>& sets) {
  run::RunOptions options = options_of(deck, std::move(text), seed, sets);
  options.quiet = options.driven = true;
  auto checked = std::make_shared<Checked>();
  const int code = with_messages(options, [&] {
    checked->deck = run::build_checked(options);
    return checked->deck.code;
  });
  if (code != run::done)
    raise("FileError", "the deck cannot be checked");
  return checked;
}

py::dict summary_of(const SharedCertificate& certificate) {
  py::dict all;
  if (!certificate)
    return all;
  all["blocks"] = certificate->blocks;
  all["holds"] = certificate->holds();
  all["overlaps"] = certificate->overlaps.size();
  all["roundings"] = certificate->roundings.size();
  all["largest_rounding"] = certificate->largest_rounding;
  all["gaps"] = certificate->gaps();
  all["rounding_slits"] = certificate->rounding_slits;
  all["t_junctions"] = certificate->t_junctions;
  all["verdict"] = verdict(*certificate);
  return all;
}

}  // namespace

void bind_run(py::module_& module) {
  module.def("_replace_file", &files::replace_file_keeping_older, py::arg("path"),
             py::arg("text"));
  module.def("_run", &run_deck, py::arg("deck"), py::arg("text"), py::arg("out"),
             py::arg("seed"), py::arg("sets"), py::arg("threads"), py::arg("until"),
             py::arg("restart"), py::arg("time_limit"), py::arg("audit"),
             py::arg("quiet"));
  module.def("_check", &check_deck, py::arg("deck"), py::arg("text"), py::arg("seed"),
             py::arg("sets"));

  // The columns belong to the Checked, which never changes.
  py::class_<Checked, std::shared_ptr<Checked>> checked(module, "Checked",
                                                        "See blocks.Assembly.");
  bind_selectors(checked, [](const Checked& self) -> const Blocks& {
    return self.deck.model.blocks;
  });
  const auto column = [&](const char* name, auto member, auto shape) {
    checked.def_property_readonly(name, [member, shape](const py::object& self) {
      const Blocks& all = self.cast<const Checked&>().deck.model.blocks;
      const auto* const data = (all.*member).data();
      py::array view(py::dtype::of<std::remove_cvref_t<decltype(*data)>>(), shape(all),
                     {}, data, self);
      view.attr("setflags")(py::arg("write") = false);
      return view;
    });
  };
  using Shape = std::vector<py::ssize_t>;
  const auto n = [](const Blocks& all) { return Shape{all.size()}; };
  column("corners", &Blocks::corner, [](const Blocks& all) {
    return Shape{all.corners(), 2};
  });
  column("first_corner", &Blocks::first_corner,
         [](const Blocks& all) { return Shape{all.size() + 1}; });
  column("joint", &Blocks::joint,
         [](const Blocks& all) { return Shape{all.corners()}; });
  column("centroid", &Blocks::centroid, [](const Blocks& all) {
    return Shape{all.size(), 2};
  });
  column("area", &Blocks::area, n);
  column("mass", &Blocks::mass, n);
  column("material", &Blocks::material, n);
  column("layer", &Blocks::layer, n);
  const auto flags = [&](const char* name, bool (Blocks::*is)(int) const) {
    checked.def_property_readonly(name, [is](const Checked& self) {
      return flags_of(self.deck.model.blocks, is);
    });
  };
  flags("is_free", &Blocks::is_free);
  flags("is_removed", &Blocks::is_removed);
  checked
      .def_property_readonly("time_step",
                             [](const Checked& self) { return self.deck.time_step; })
      .def_property_readonly(
          "title",
          [](const Checked& self) { return text_of(self.deck.model.settings.title); })
      .def_property_readonly(
          "seed", [](const Checked& self) { return self.deck.model.settings.seed; })
      .def_property_readonly("_units",
                             [](const Checked& self) {
                               return unit_names(self.deck.model.settings.units);
                             })
      .def_property_readonly("materials",
                             [](const Checked& self) {
                               return material_names(
                                   self.deck.model.settings.materials);
                             })
      .def_property_readonly("report",
                             [](const Checked& self) { return text_of(self.report()); })
      .def_property_readonly(
          "certificate",
          [](const Checked& self) { return summary_of(self.deck.certificate); })
      .def("__len__",
           [](const Checked& self) { return self.deck.model.blocks.size(); });
}

}  // namespace blocks::python
