// Trees: load, check, tick, run, watch.
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bt_core/analysis/formats/full_xml.h"
#include "bt_core/base/diagnostic.h"
#include "bt_core/engine/compile/check_project.h"
#include "bt_core/frames/tree_description.h"
#include "bt_core/model/project.h"
#include "bt_core/python/bind.h"
#include "bt_core/python/tree.h"
#include "bt_core/python/values.h"
#include "bt_core/record/recorder.h"

namespace coppice::python {
namespace {

using SharedRegistry = std::shared_ptr<Registry>;

// Python holds no const objects.
struct Loadable {
  std::shared_ptr<const Program> program;
};
using Loaded = std::pair<std::optional<Loadable>, std::vector<Diagnostic>>;

// A copy: who fills the registry further changes no tree that runs.
std::shared_ptr<const Registry> CopyOf(const SharedRegistry& registry) {
  return std::make_shared<const Registry>(*registry);
}

Loaded Load(std::optional<Project> project, const SharedRegistry& registry,
            const std::string& tree_id, Diagnostics diagnostics) {
  std::shared_ptr<const Program> program;
  if (project) {
    program = Compile(std::make_shared<const Project>(*std::move(project)), CopyOf(registry),
                      diagnostics, tree_id);
  }
  if (!program) return {std::nullopt, diagnostics.all()};
  return {Loadable{program}, diagnostics.all()};
}

Loaded LoadFile(const std::string& path, const SharedRegistry& registry,
                const std::string& tree_id) {
  const py::gil_scoped_release release;
  Diagnostics diagnostics;
  auto project = Project::FromFile(path, diagnostics);
  return Load(std::move(project), registry, tree_id, std::move(diagnostics));
}

Loaded LoadText(const std::string& text, const std::string& file, const SharedRegistry& registry,
                const std::string& tree_id) {
  const py::gil_scoped_release release;
  Diagnostics diagnostics;
  auto project = Project::FromText(text, file, diagnostics);
  return Load(std::move(project), registry, tree_id, std::move(diagnostics));
}

// By file in the order of first mention, then by line and column.
std::vector<Diagnostic> Sorted(std::vector<Diagnostic> all) {
  std::map<std::string, std::size_t> files;
  for (const Diagnostic& diagnostic : all) files.emplace(diagnostic.where.file, files.size());
  const auto place = [&files](const Diagnostic& d) {
    return std::make_tuple(files.at(d.where.file), d.where.line, d.where.column);
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return place(a) < place(b); });
  return all;
}

std::vector<Diagnostic> Check(std::optional<Project> project, const SharedRegistry& registry,
                              bool all_types_known, Diagnostics diagnostics) {
  if (project) {
    CheckProject(std::make_shared<const Project>(*std::move(project)), CopyOf(registry),
                 {all_types_known}, diagnostics);
  }
  return Sorted(diagnostics.all());
}

std::vector<Diagnostic> CheckFiles(const std::vector<std::string>& paths,
                                   const SharedRegistry& registry, bool all_types_known) {
  const py::gil_scoped_release release;
  Diagnostics diagnostics;
  auto project = Project::FromFiles(paths, diagnostics);
  return Check(std::move(project), registry, all_types_known, std::move(diagnostics));
}

std::vector<Diagnostic> CheckText(const std::string& text, const std::string& file,
                                  const SharedRegistry& registry, bool all_types_known) {
  const py::gil_scoped_release release;
  Diagnostics diagnostics;
  auto project = Project::FromText(text, file, diagnostics);
  return Check(std::move(project), registry, all_types_known, std::move(diagnostics));
}

void BindDiagnostic(py::module_& module) {
  py::class_<Diagnostic>(module, "Diagnostic")
      .def_property_readonly("is_error",
                             [](const Diagnostic& d) { return d.severity == Severity::kError; })
      .def_property_readonly("file", [](const Diagnostic& d) { return TextOf(d.where.file); })
      .def_property_readonly("line", [](const Diagnostic& d) { return d.where.line; })
      .def_property_readonly("column", [](const Diagnostic& d) { return d.where.column; })
      .def_property_readonly("message", [](const Diagnostic& d) { return TextOf(d.message); })
      .def_property_readonly("hint", [](const Diagnostic& d) { return TextOf(d.hint); })
      .def("__str__", [](const Diagnostic& d) { return TextOf(ToString(d)); })
      .def("__repr__", [](const Diagnostic& d) { return TextOf("<" + ToString(d) + ">"); });
}

void BindClocks(py::module_& module) {
  py::class_<Clock, std::shared_ptr<Clock>>(module, "Clock").def("now", [](const Clock& clock) {
    return ToSeconds(clock.Now());
  });
  py::class_<WallClock, Clock, std::shared_ptr<WallClock>>(module, "WallClock").def(py::init<>());
  py::class_<SimulatedClock, Clock, std::shared_ptr<SimulatedClock>>(module, "SimulatedClock")
      .def(py::init(
               [](double start) { return std::make_shared<SimulatedClock>(FromSeconds(start)); }),
           py::arg("start") = 0.0)
      .def(
          "advance",
          [](SimulatedClock& clock, double seconds) {
            if (seconds < 0) throw py::value_error("time does not go back");
            const Duration step = FromSeconds(seconds);
            if (step > Time::max() - clock.Now())
              throw py::value_error("a clock ends in 292 years");
            clock.Advance(step);
          },
          py::arg("seconds"));
}

// Path, registration ID, name, file, line and column of each node.
py::list NodesOf(const Program& program) {
  py::list nodes;
  for (NodeIndex i{0}; i < program.nodes.size(); ++i) {
    const SourceLocation where = program.Location(i);
    nodes.append(py::make_tuple(TextOf(program.Path(i)), TextOf(program.Id(i)),
                                TextOf(program.Name(i)), TextOf(where.file), where.line,
                                where.column));
  }
  return nodes;
}

ExceptionPolicy PolicyFrom(const std::string& text) {
  if (text == "fail") return ExceptionPolicy::kFailNode;
  if (text == "halt") return ExceptionPolicy::kHaltTree;
  if (text == "raise") return ExceptionPolicy::kRethrow;
  throw py::value_error("on_exception is \"fail\", \"halt\" or \"raise\", not \"" + text + "\"");
}

RunOptions OptionsFrom(std::optional<double> period, bool fixed_rate, bool forever) {
  RunOptions options;
  options.pace = fixed_rate ? Pace::kFixedRate : Pace::kEvents;
  options.period = period ? FromSeconds(*period) : kForever;
  options.forever = forever;
  return options;
}

// The full text, for tools that know neither the files nor the node types.
std::string XmlOf(Tree& tree) {
  return FullXml(DescribeTree(tree.program(), BeginRun(tree.clock())));
}

void BindTree(py::module_& module) {
  py::class_<Loadable>(module, "Program");
  py::class_<Tree, std::shared_ptr<Tree>>(module, "Tree")
      .def(py::init([](const Loadable& loaded, std::shared_ptr<Clock> clock,
                       const std::string& on_exception) {
             return Tree::Make(loaded.program, std::move(clock), PolicyFrom(on_exception));
           }),
           py::arg("program"), py::arg("clock"), py::arg("on_exception"))
      .def("tick", &Tree::Tick)
      .def(
          "run",
          [](Tree& tree, std::optional<double> period, bool fixed_rate, bool forever) {
            return tree.Run(OptionsFrom(period, fixed_rate, forever));
          },
          py::arg("period"), py::arg("fixed_rate"), py::arg("forever"))
      .def("halt", &Tree::Halt)
      .def("stop", &Tree::Stop)
      .def("request_tick", &Tree::RequestTick)
      .def("is_running", &Tree::is_running)
      .def("status", &Tree::RootStatus)
      .def("statuses", &Tree::Statuses)
      .def("ticks", &Tree::Ticks)
      .def("next_tick", &Tree::NextTick)
      .def("now", [](Tree& tree) { return ToSeconds(tree.clock().Now()); })
      .def("nodes", [](const Tree& tree) { return NodesOf(tree.program()); })
      .def("keys", &Tree::Keys)
      .def(
          "is_set", [](Tree& tree, const std::string& key) { return tree.IsSet(tree.Find(key)); },
          py::arg("key"))
      .def(
          "get", [](Tree& tree, const std::string& key) { return tree.Get(tree.Find(key)); },
          py::arg("key"))
      .def("set", &Tree::Set, py::arg("key"), py::arg("value"))
      .def("main_tree", [](const Tree& tree) { return TextOf(tree.program().trees.front().id); })
      .def("xml", [](Tree& tree) { return TextOf(XmlOf(tree)); });
}

// A recorder and the tree that it needs.
class TreeRecorder {
 public:
  TreeRecorder(std::shared_ptr<Tree> tree, const std::string& path,
               const std::map<std::string, std::string>& metadata)
      : tree_(std::move(tree)) {
    RecorderOptions options;
    options.metadata.assign(metadata.begin(), metadata.end());
    tree_->UseBetweenTicks([&](Executor&) { recorder_.emplace(tree_->stream(), path, options); });
  }
  ~TreeRecorder() {
    if (recorder_) tree_->Use([this](Executor&) { recorder_.reset(); });
  }

  void Close() {
    Outcome closed;
    tree_->UseBetweenTicks([&](Executor&) {
      if (recorder_) closed = recorder_->Close();
      recorder_.reset();
    });
    if (!closed) throw std::runtime_error(closed.problem());
  }
  void Note(const std::string& kind, const std::string& text) {
    tree_->Use([&](Executor& executor) {
      if (recorder_) recorder_->Note(executor.clock().Now(), kind, text);
    });
  }

 private:
  const std::shared_ptr<Tree> tree_;
  std::optional<Recorder> recorder_;
};

void BindRecorder(py::module_& module) {
  py::class_<TreeRecorder>(module, "TreeRecorder")
      .def(py::init<std::shared_ptr<Tree>, const std::string&,
                    const std::map<std::string, std::string>&>(),
           py::arg("tree"), py::arg("path"), py::arg("metadata"))
      .def("close", &TreeRecorder::Close)
      .def("note", &TreeRecorder::Note, py::arg("kind"), py::arg("text"));
}

}  // namespace

void BindTrees(py::module_& module) {
  BindDiagnostic(module);
  BindClocks(module);
  BindTree(module);
  BindRecorder(module);
  module.def("load_file", &LoadFile, py::arg("path"), py::arg("registry"), py::arg("tree"));
  module.def("load_text", &LoadText, py::arg("text"), py::arg("file"), py::arg("registry"),
             py::arg("tree"));
  module.def("check_files", &CheckFiles, py::arg("paths"), py::arg("registry"),
             py::arg("all_types_known"));
  module.def("check_text", &CheckText, py::arg("text"), py::arg("file"), py::arg("registry"),
             py::arg("all_types_known"));
}

}  // namespace coppice::python
