#include "bt_core/frames/history_size.h"

namespace coppice {

std::size_t BytesOf(const TreeDescription& tree) {
  std::size_t bytes = sizeof(tree) + tree.models.size();
  for (const DescribedDocument& document : tree.documents) {
    bytes += sizeof(document) + document.file.size() + document.text.size();
  }
  for (const DescribedNode& node : tree.nodes) {
    bytes += sizeof(node) + node.path.size() + node.id.size();
    for (const DescribedPort& port : node.ports) bytes += sizeof(port) + port.name.size();
  }
  for (const DescribedSlot& slot : tree.slots) {
    bytes += sizeof(slot) + slot.scope.size() + slot.name.size() + slot.type.size();
  }
  return bytes;
}

std::size_t BytesOf(const HistoryState& state) {
  std::size_t bytes = sizeof(state) + state.statuses.size() + state.last.size();
  for (const std::string& value : state.values) bytes += sizeof(value) + value.size();
  return bytes;
}

std::size_t BytesOf(const HistoryNote& note) {
  return sizeof(note) + note.kind.size() + note.text.size();
}

}  // namespace coppice
