#include "bt_core/live/groot2/groot2_protocol.h"

#include <algorithm>
#include <optional>
#include <random>
#include <utility>

namespace coppice::groot2 {
namespace {

std::uint32_t ReadNumber(std::string_view bytes) {
  std::uint32_t number = 0;
  for (int i = 3; i >= 0; --i) {
    number = number << 8 | static_cast<unsigned char>(bytes[static_cast<std::size_t>(i)]);
  }
  return number;
}

// Whether a type of request has a second part; nothing for what is no request.
std::optional<bool> HasArgument(char type) {
  switch (static_cast<RequestType>(type)) {
    case RequestType::kFullTree:
    case RequestType::kStatus:
    case RequestType::kDumpHooks:
    case RequestType::kRemoveAllHooks:
    case RequestType::kDisableAllHooks:
    case RequestType::kTransitions:
      return false;
    case RequestType::kBlackboard:
    case RequestType::kInsertHooks:
    case RequestType::kRemoveHook:
    case RequestType::kUnlock:
    case RequestType::kToggleRecording:
    case RequestType::kExtension:
      return true;
    case RequestType::kBreakpointReached:
      break;
  }
  return std::nullopt;
}

void AppendNumber(std::string& out, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(number >> shift & 0xff);
}

}  // namespace

Expected<Request> ParseRequest(const Parts& parts) {
  if (parts.empty() || parts[0].size() != kRequestHeaderSize) {
    return Problem{"wrong request header"};
  }
  const std::string_view header = parts[0];
  const std::optional<bool> has_argument = HasArgument(header[1]);
  if (!has_argument) return Problem{"Request not recognized"};
  Request request{static_cast<RequestType>(header[1]), ReadNumber(header.substr(2)), {}};
  if (*has_argument) {
    if (parts.size() != 2) return Problem{"must be 2 parts message"};
    request.argument = parts[1];
  }
  return request;
}

std::string MakeHeader(char type, std::uint32_t number) {
  std::string header;
  header += static_cast<char>(kVersion);
  header += type;
  AppendNumber(header, number);
  return header;
}

TreeId RandomTreeId() {
  std::random_device device;
  std::uniform_int_distribution<int> byte(0, 255);
  TreeId id;
  std::generate(id.begin(), id.end(), [&] { return static_cast<char>(byte(device)); });
  id[6] = static_cast<char>((id[6] & 0x0f) | 0x40);
  id[8] = static_cast<char>((id[8] & 0x3f) | 0x80);
  return id;
}

Parts MakeReply(const Request& request, const TreeId& tree) {
  std::string header = MakeHeader(static_cast<char>(request.type), request.number);
  header.append(tree.data(), tree.size());
  return {std::move(header)};
}

Parts MakeReply(const Request& request, const TreeId& tree, std::string payload) {
  Parts parts = MakeReply(request, tree);
  parts.push_back(std::move(payload));
  return parts;
}

Parts MakeError(std::string text) { return {"error", std::move(text)}; }

void AppendStatus(std::string& payload, std::uint16_t uid, std::uint8_t status) {
  payload += static_cast<char>(uid & 0xff);
  payload += static_cast<char>(uid >> 8);
  payload += static_cast<char>(status);
}

std::vector<std::string_view> SplitNames(std::string_view names) {
  std::vector<std::string_view> result;
  while (!names.empty()) {
    const std::size_t end = std::min(names.find(';'), names.size());
    if (end > 0) result.push_back(names.substr(0, end));
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return result;
}

}  // namespace coppice::groot2
