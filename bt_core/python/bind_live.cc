// The live view of a tree: the editor, `coppice live` and Groot2 watch and debug it.
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bt_core/live/server/live_publisher.h"
#include "bt_core/python/bind.h"
#include "bt_core/python/tree.h"

namespace coppice::python {
namespace {

// A publisher and the tree that it needs.
class TreeLive {
 public:
  TreeLive(std::shared_ptr<Tree> tree, std::uint16_t port, const std::string& address,
           const std::string& token)
      : tree_(std::move(tree)) {
    LiveOptions options;
    options.port = port;
    options.address = address;
    options.token = token;
    tree_->UseBetweenTicks([&](Executor&) { publisher_.emplace(tree_->stream(), options); });
  }
  ~TreeLive() {
    tree_->Use([this](Executor&) { publisher_.reset(); });
  }
  TreeLive(const TreeLive&) = delete;
  TreeLive& operator=(const TreeLive&) = delete;

  void Close() {
    tree_->UseBetweenTicks([this](Executor&) { publisher_.reset(); });
  }
  std::uint16_t Port() const { return publisher_ ? publisher_->port() : 0; }

 private:
  const std::shared_ptr<Tree> tree_;
  std::optional<LivePublisher> publisher_;
};

}  // namespace

void BindLive(pybind11::module_& module) {
  py::class_<TreeLive>(module, "TreeLive")
      .def(py::init<std::shared_ptr<Tree>, std::uint16_t, const std::string&, const std::string&>(),
           py::arg("tree"), py::arg("port"), py::arg("address"), py::arg("token"))
      .def("close", &TreeLive::Close)
      .def("port", &TreeLive::Port);
}

}  // namespace coppice::python
