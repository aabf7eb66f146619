#include "bt_core/analysis/formats/btlog.h"

namespace coppice {
namespace {

constexpr std::string_view kMagic = "BTCPP4-FileLogger2";
constexpr char kVersion = 1;
constexpr std::size_t kHeadSize = kMagic.size() + 1 + 4;
constexpr std::size_t kTransitionSize = 9;
constexpr std::int64_t kLatest =
    INT64_MAX / 2000;  // as nanoseconds it leaves room for what follows

void Append(std::uint64_t number, int bytes, std::string& out) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(number >> (8 * i) & 0xff);
}

std::uint64_t Read(std::string_view bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    number = number << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return number;
}

}  // namespace

std::string WriteBtlog(const Btlog& log) {
  std::string out(kMagic);
  out += kVersion;
  Append(log.xml.size(), 4, out);
  out += log.xml;
  const std::int64_t first = log.transitions.empty() ? 0 : log.transitions.front().time;
  Append(static_cast<std::uint64_t>(first), 8, out);
  for (const BtlogTransition& transition : log.transitions) {
    Append(static_cast<std::uint64_t>(transition.time - first), 6, out);
    Append(transition.uid, 2, out);
    out += static_cast<char>(transition.status);
  }
  return out;
}

std::optional<Btlog> ReadBtlog(std::string_view bytes, const std::string& file,
                               Diagnostics& diagnostics) {
  if (bytes.size() < kHeadSize || bytes.substr(0, kMagic.size()) != kMagic) {
    diagnostics.Error({file}, "is no log of BehaviorTree.CPP's FileLogger2");
    return std::nullopt;
  }
  if (bytes[kMagic.size()] != kVersion) {
    diagnostics.Error({file}, "is a log of version " +
                                  std::to_string(static_cast<int>(bytes[kMagic.size()])) +
                                  ", expected 1");
    return std::nullopt;
  }
  const std::uint64_t xml_size = Read(bytes.substr(kMagic.size() + 1, 4));
  bytes.remove_prefix(kHeadSize);
  if (xml_size > bytes.size() || bytes.size() - xml_size < 8) {
    diagnostics.Error({file}, "ends within the XML of its tree");
    return std::nullopt;
  }
  Btlog log;
  log.xml = bytes.substr(0, xml_size);
  const auto first = static_cast<std::int64_t>(Read(bytes.substr(xml_size, 8)));
  if (first < 0 || first > kLatest) {
    diagnostics.Error({file}, "starts at a time that makes no sense: " + std::to_string(first) +
                                  " us since 1970");
    return std::nullopt;
  }
  bytes.remove_prefix(xml_size + 8);
  for (; bytes.size() >= kTransitionSize; bytes.remove_prefix(kTransitionSize)) {
    const auto status = static_cast<unsigned char>(bytes[8]);
    if (status > static_cast<unsigned char>(Status::kSkipped)) {
      diagnostics.Error({file}, "has a transition to status " + std::to_string(status));
      return std::nullopt;
    }
    log.transitions.push_back({first + static_cast<std::int64_t>(Read(bytes.substr(0, 6))),
                               static_cast<std::uint16_t>(Read(bytes.substr(6, 2))),
                               static_cast<Status>(status)});
  }
  if (!bytes.empty()) diagnostics.Warning({file}, "is cut off within its last transition");
  return log;
}

}  // namespace coppice
