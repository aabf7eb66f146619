// The bytes are those of bt_core/analysis/formats/btlog.h, written as they come.
#include <array>
#include <fstream>

#include "behaviortree_cpp/loggers/bt_file_logger_v2.h"
#include "behaviortree_cpp/xml_parsing.h"

namespace BT {
namespace {

constexpr char kName[] = "BTCPP4-FileLogger2";
constexpr char kVersion = 1;

// Little endian.
template <std::size_t size>
void Put(std::ostream& out, std::uint64_t number) {
  std::array<char, size> bytes{};
  for (std::size_t k = 0; k < size; ++k) bytes[k] = static_cast<char>(number >> (8 * k));
  out.write(bytes.data(), size);
}

const std::filesystem::path& WithExtension(const std::filesystem::path& path) {
  if (path.extension() == ".btlog") return path;
  throw RuntimeError("FileLogger2: the file extension must be [.btlog]");
}

std::uint64_t Microseconds(Duration duration) {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(duration).count());
}

}  // namespace

struct FileLogger2::Pimpl {
  std::ofstream file;
  std::uint64_t start = 0;
};

FileLogger2::FileLogger2(const Tree& tree, const std::filesystem::path& filepath)
    : FileLogger2(tree, WithExtension(filepath), AnyName()) {}

FileLogger2::FileLogger2(const Tree& tree, const std::filesystem::path& filepath, AnyName)
    : _p(std::make_unique<Pimpl>()) {
  _p->file.open(filepath, std::ios::binary | std::ios::trunc);
  if (!_p->file) throw RuntimeError("problem opening file in FileLogger2: ", filepath.string());
  const std::string xml = WriteTreeToXML(tree, true, true);
  _p->file.write(kName, sizeof(kName) - 1);
  _p->file.put(kVersion);
  Put<4>(_p->file, xml.size());
  _p->file << xml;
  _p->start = Microseconds(std::chrono::system_clock::now().time_since_epoch());
  Put<8>(_p->file, _p->start);
  _p->file.flush();
  subscribeToTreeChanges(tree.rootNode());
}

FileLogger2::~FileLogger2() { unsubscribeFromTreeChanges(); }

void FileLogger2::callback(Duration timestamp, const TreeNode& node, NodeStatus,
                           NodeStatus status) {
  const std::uint64_t time = Microseconds(timestamp);
  Put<6>(_p->file, time > _p->start ? time - _p->start : 0);
  Put<2>(_p->file, node.UID());
  Put<1>(_p->file, static_cast<std::uint64_t>(status));
}

void FileLogger2::flush() { _p->file.flush(); }

}  // namespace BT
