#include "bt_core/frames/history_decoder.h"
#include "tests/fuzz/frames.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/history_check.h"

namespace coppice::fuzz {
namespace {

class Follower final : public HistoryHandler {
 public:
  void OnTree(const TreeDescription& tree) override { check.OnTree(tree); }
  void OnState(const HistoryState& state) override { check.OnState(state); }
  void OnTick(const TickEvents& events) override { check.OnTick(events); }

  HistoryCheck check;
};

}  // namespace

int FuzzHistory(std::string_view bytes) {
  HistoryDecoder decoder;
  HistoryDecoder wild;  // gets the bytes as they are
  Packer packer;
  Follower follower;
  Follower wild_follower;
  for (LooseFrame frame; TakeFrame(bytes, frame);) {
    const Bytes sealed = Seal(frame, packer);
    if (!decoder.Decode(sealed.data(), sealed.size(), follower)) Require(!decoder.follows());
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(frame.payload.data());
    if (!wild.Decode(bytes, frame.payload.size(), wild_follower)) Require(!wild.follows());
  }
  return follower.check.reached();
}

}  // namespace coppice::fuzz
