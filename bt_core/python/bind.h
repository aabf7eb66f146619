// The parts of the module coppice._native, by subject.
#ifndef COPPICE_BT_CORE_PYTHON_BIND_H_
#define COPPICE_BT_CORE_PYTHON_BIND_H_

#include <pybind11/pybind11.h>

namespace coppice::python {

void BindLeaves(pybind11::module_& module);   ///< Status, Registry, NodeLink
void BindTrees(pybind11::module_& module);    ///< load, check, Tree, clocks, recorder, live view
void BindLive(pybind11::module_& module);     ///< the live view, where it is built
void BindRecords(pybind11::module_& module);  ///< Record
void BindTesting(pybind11::module_& module);  ///< LeafHarness, scenarios

}  // namespace coppice::python

#endif  // COPPICE_BT_CORE_PYTHON_BIND_H_
