// Node types: what Python tells of its leaves, and what a leaf sees of its tree.
#include <dlfcn.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/engine/compile/models.h"
#include "bt_core/engine/compile/schema.h"
#include "bt_core/model/manifest.h"
#include "bt_core/python/bind.h"
#include "bt_core/python/leaf.h"
#include "bt_core/python/values.h"

namespace coppice::python {
namespace {

PortDirection DirectionFrom(const std::string& text) {
  if (text == "input") return PortDirection::kInput;
  return text == "output" ? PortDirection::kOutput : PortDirection::kInOut;
}

std::string DefaultFrom(const PortDeclaration& port, const py::object& value) {
  const std::string where = "default of port \"" + port.name + "\": ";
  try {
    return FromPython(port.type, value).Print();
  } catch (const py::type_error& error) {
    throw py::type_error(where + error.what());
  } catch (const py::value_error& error) {
    throw py::value_error(where + error.what());
  }
}

// (name, direction, type, description, required, (default,) or None)
PortDeclaration DeclarationFrom(const py::tuple& told) {
  PortDeclaration port;
  port.name = told[0].cast<std::string>();
  port.direction = DirectionFrom(told[1].cast<std::string>());
  port.type = &TypeFromAnnotation(told[2]);
  port.description = told[3].cast<std::string>();
  port.required = told[4].cast<bool>();
  if (!told[5].is_none()) {
    port.default_text = DefaultFrom(port, told[5].cast<py::tuple>()[0]);
  }
  return port;
}

NodeCategory CategoryFrom(const std::string& text) {
  if (text == "condition") return NodeCategory::kCondition;
  if (text == "control") return NodeCategory::kControl;
  return text == "decorator" ? NodeCategory::kDecorator : NodeCategory::kAction;
}

void AddNode(Registry& registry, const std::string& id, const std::string& category,
             const std::string& description, const py::list& ports, py::object make) {
  NodeClass added;
  added.manifest = {id, CategoryFrom(category), description, {}};
  for (const py::handle port : ports) {
    added.manifest.ports.push_back(DeclarationFrom(port.cast<py::tuple>()));
  }
  added.make = Object(std::move(make));
  added.is_condition = added.manifest.category == NodeCategory::kCondition;
  AddNodeClass(registry, std::move(added));
}

// A plugin uses the engine of the program, which lies in this module: Python has loaded it for
// itself alone.
void LoadPlugin(Registry& registry, const std::string& path) {
  Dl_info module;
  if (dladdr(reinterpret_cast<void*>(&LoadPlugin), &module) != 0) {
    dlopen(module.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_GLOBAL);
  }
  registry.LoadPlugin(path);
}

void BindRegistry(py::module_& module) {
  py::class_<Registry, std::shared_ptr<Registry>>(module, "Registry")
      .def(py::init<>())
      .def("add_node", &AddNode, py::arg("id"), py::arg("category"), py::arg("description"),
           py::arg("ports"), py::arg("make"))
      .def("add_script_constant", &Registry::AddScriptConstant, py::arg("name"), py::arg("value"))
      .def("load_plugin", &LoadPlugin, py::arg("path"))
      .def("ids", &Registry::Ids)
      .def("models", &WriteModels)
      .def("schema", &WriteSchema)
      .def("describe", &DescribeNodes);
}

void BindNodeLink(py::module_& module) {
  py::class_<Sender<Object>>(module, "Sender")
      .def(
          "__call__",
          [](const Sender<Object>& sender, py::object answer) {
            sender.Send(Object(std::move(answer)));
          },
          py::arg("answer"));
  py::class_<NodeLink, std::shared_ptr<NodeLink>>(module, "NodeLink")
      .def("read", &NodeLink::Read, py::arg("port"))
      .def("has_value", &NodeLink::HasValue, py::arg("port"))
      .def("writes", &NodeLink::Writes, py::arg("port"))
      .def("write", &NodeLink::Write, py::arg("port"), py::arg("value"))
      .def("say", &NodeLink::Say, py::arg("text"))
      .def("now", &NodeLink::Now)
      .def("wake_at", &NodeLink::WakeAt, py::arg("time"))
      .def("wake_after", &NodeLink::WakeAfter, py::arg("seconds"))
      .def("drain_for", &NodeLink::DrainFor, py::arg("seconds"))
      .def("path", &NodeLink::Path)
      .def("new_sender", &NodeLink::NewSender)
      .def("take", &NodeLink::Take)
      .def("request_tick", &NodeLink::RequestTick)
      .def("count_children", &NodeLink::CountChildren)
      .def("tick_child", &NodeLink::TickChild, py::arg("child"))
      .def("status_of_child", &NodeLink::StatusOfChild, py::arg("child"))
      .def("halt_child", &NodeLink::HaltChild, py::arg("child"));
}

}  // namespace

void BindLeaves(py::module_& module) {
  py::enum_<Status>(module, "Status")
      .value("IDLE", Status::kIdle)
      .value("RUNNING", Status::kRunning)
      .value("SUCCESS", Status::kSuccess)
      .value("FAILURE", Status::kFailure)
      .value("SKIPPED", Status::kSkipped);
  py::register_exception<UnsetPort>(module, "UnsetInput", PyExc_LookupError);
  BindRegistry(module);
  BindNodeLink(module);
  module.def("nearest_name", &NearestName, py::arg("name"), py::arg("candidates"));
}

}  // namespace coppice::python
