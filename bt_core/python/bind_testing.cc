// Tests of leaves and of whole trees from Python.
#include <pybind11/stl.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/model/project.h"
#include "bt_core/python/bind.h"
#include "bt_core/python/leaf.h"
#include "bt_core/python/values.h"
#include "bt_core/testing/leaf_harness.h"
#include "bt_core/testing/scenario.h"

namespace coppice::python {
namespace {

// The GIL is let go while C++ ticks; what ends the program comes out of the tick.
template <class Function>
auto WithoutGil(Function function) {
  const Interruption interruption(nullptr);
  const auto result = [&] {
    const py::gil_scoped_release release;
    return function();
  }();
  interruption.Raise();
  return result;
}

class Harness {
 public:
  Harness(const std::shared_ptr<Registry>& registry, const std::string& id)
      : harness_(registry, id) {}

  void Set(const std::string& port, py::handle value) {
    harness_.SetValue(port, FromPython(harness_.TypeOfPort(port), value));
  }
  py::object Get(const std::string& port) const { return ToPython(harness_.ValueOf(port)); }
  bool WasWritten(const std::string& port) const {
    harness_.TypeOfPort(port);  // throws if there is none
    return harness_.WasWritten(port);
  }
  Status Tick() {
    return WithoutGil([this] { return harness_.Tick(); });
  }
  Status TickUntilDone(double limit) {
    const Duration most = FromSeconds(limit);
    return WithoutGil([this, most] { return harness_.TickUntilDone(most); });
  }
  bool WaitUntilStopped() {
    return WithoutGil([this] { return harness_.WaitUntilStopped(); });
  }
  void Halt() {
    WithoutGil([this] { return harness_.Halt(), true; });
  }
  void Advance(double seconds) { harness_.Advance(FromSeconds(seconds)); }
  double NextTick() const {
    const Time next = harness_.next_tick();
    return next == kNever ? std::numeric_limits<double>::infinity() : ToSeconds(next);
  }
  py::list Messages() const {
    py::list messages;
    for (const std::string& message : harness_.messages()) messages.append(TextOf(message));
    return messages;
  }

 private:
  LeafHarness harness_;
};

void BindHarness(py::module_& module) {
  py::class_<Harness>(module, "Harness")
      .def(py::init<const std::shared_ptr<Registry>&, const std::string&>(), py::arg("registry"),
           py::arg("id"))
      .def("set", &Harness::Set, py::arg("port"), py::arg("value"))
      .def("get", &Harness::Get, py::arg("port"))
      .def("was_written", &Harness::WasWritten, py::arg("port"))
      .def("tick", &Harness::Tick)
      .def("tick_until_done", &Harness::TickUntilDone, py::arg("limit"))
      .def("wait_until_stopped", &Harness::WaitUntilStopped)
      .def("halt", &Harness::Halt)
      .def("advance", &Harness::Advance, py::arg("seconds"))
      .def("next_tick", &Harness::NextTick)
      .def("messages", &Harness::Messages);
}

// Scenarios of one file with the program that they run.
class Suite {
 public:
  Suite(ScenarioSuite suite, std::shared_ptr<const Program> program)
      : suite_(std::move(suite)), program_(std::move(program)) {}

  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const Scenario& scenario : suite_.scenarios) names.push_back(scenario.name);
    return names;
  }

  // Place, what, expected and got of each difference.
  py::list Run(std::size_t number) const {
    const Scenario& scenario = suite_.scenarios.at(number);
    const ScenarioResult result =
        WithoutGil([&] { return RunScenario(*program_, suite_, scenario); });
    py::list differences;
    for (const Difference& one : result.differences) {
      differences.append(py::make_tuple(TextOf(one.where.file), one.where.line, one.where.column,
                                        one.step, TextOf(one.what), TextOf(one.expected),
                                        TextOf(one.got)));
    }
    return differences;
  }

 private:
  const ScenarioSuite suite_;
  const std::shared_ptr<const Program> program_;
};

std::pair<std::shared_ptr<Suite>, std::vector<Diagnostic>> LoadSuite(
    const std::string& path, const std::shared_ptr<Registry>& registry) {
  const py::gil_scoped_release release;
  Diagnostics diagnostics;
  std::optional<ScenarioSuite> suite = LoadScenarios(path, diagnostics);
  if (!suite) return {nullptr, diagnostics.all()};
  std::optional<Project> project = Project::FromFile(suite->tree_file, diagnostics);
  if (!project) return {nullptr, diagnostics.all()};
  const auto program =
      CompileSuite(*suite, *std::move(project), std::make_shared<Registry>(*registry), diagnostics);
  if (!program) return {nullptr, diagnostics.all()};
  return {std::make_shared<Suite>(*std::move(suite), program), diagnostics.all()};
}

}  // namespace

void BindTesting(py::module_& module) {
  BindHarness(module);
  py::class_<Suite, std::shared_ptr<Suite>>(module, "Suite")
      .def("names", &Suite::Names)
      .def("run", &Suite::Run, py::arg("number"));
  module.def("load_suite", &LoadSuite, py::arg("path"), py::arg("registry"));
}

}  // namespace coppice::python
