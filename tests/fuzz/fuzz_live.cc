#include <algorithm>
#include <string_view>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/served_tree.h"

namespace coppice::fuzz {
namespace {

groot2::Parts MakeRequest(std::string_view line) {
  groot2::Parts parts;
  if (line.empty()) return parts;
  parts.push_back(groot2::MakeHeader(line[0], 7));
  if (line.size() > 1) parts.emplace_back(line.substr(1));
  if (line[0] == '!') parts[0] = line;  // a header of another length
  return parts;
}

}  // namespace

int FuzzLive(std::string_view bytes) {
  CheckingOutbox outbox;
  ServedTree tree(outbox);
  // A line is a request: who asks and when, the type, its second part.
  while (!bytes.empty()) {
    const std::string_view line = bytes.substr(0, bytes.find('\n'));
    bytes.remove_prefix(std::min(line.size() + 1, bytes.size()));
    if (line.empty()) continue;
    const auto who = static_cast<unsigned char>(line[0]);
    if (who % 16 == 0) tree.OutlastClients();
    tree.Serve(ClientId(who % 4), who % 8 != 0, MakeRequest(line.substr(1)));
  }
  return outbox.good;
}

}  // namespace coppice::fuzz
