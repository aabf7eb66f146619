// coppice._native: what the package `coppice` is made of. Its texts are in _native.pyi.
#include <pybind11/pybind11.h>

#include "bt_core/base/version.h"
#include "bt_core/python/bind.h"
#include "bt_core/python/tree.h"

PYBIND11_MODULE(_native, module) {
  using namespace coppice;
  python::BindLeaves(module);
  python::BindTrees(module);
#ifdef COPPICE_LIVE
  python::BindLive(module);
#endif
  python::BindRecords(module);
  python::BindTesting(module);
  module.attr("__version__") = kVersion;
  module.def("end_all_trees", &python::EndAllTrees);
}
