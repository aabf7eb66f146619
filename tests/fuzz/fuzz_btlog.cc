#include <algorithm>

#include "bt_core/analysis/formats/export.h"
#include "bt_core/analysis/formats/import_btlog.h"
#include "bt_core/analysis/formats/write_record.h"
#include "bt_core/frames/history_decoder.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/history_check.h"

namespace coppice::fuzz {
namespace {

class Checker final : public HistoryHandler {
 public:
  void OnTree(const TreeDescription& tree) override { check.OnTree(tree); }
  void OnState(const HistoryState& state) override { check.OnState(state); }
  void OnTick(const TickEvents& events) override { check.OnTick(events); }

  HistoryCheck check;
};

// A log whose sizes are right.
std::string MakeLog(std::string_view bytes) {
  constexpr std::size_t kTimeSize = 8;
  const std::string_view time = bytes.substr(0, kTimeSize);
  const std::string_view xml =
      bytes.substr(time.size(), bytes.find('\0', time.size()) - time.size());
  const std::string_view rest = bytes.substr(std::min(bytes.size(), time.size() + xml.size() + 1));
  std::string log = "BTCPP4-FileLogger2\1";
  for (int shift = 0; shift < 32; shift += 8) log += static_cast<char>(xml.size() >> shift);
  log += xml;
  log += time;
  log.resize(log.size() + kTimeSize - time.size());
  return log.append(rest);
}

// What is written of it is a record in order.
int Reached(const Recording& run) {
  const std::string record = ToRecord(run);
  HistoryDecoder decoder;
  Checker checker;
  for (std::size_t at = kPreambleSize; at < record.size();) {
    const auto* const frame = reinterpret_cast<const std::uint8_t*>(record.data() + at);
    const std::size_t size = kFrameHeaderSize + ReadFrameHeader(frame).payload_size;
    Require(size <= record.size() - at && decoder.Decode(frame, size, checker));
    at += size;
  }
  return checker.check.reached() == 3 ? 2 : 1;
}

}  // namespace

int FuzzBtlog(std::string_view bytes) {
  Diagnostics diagnostics;
  FromBtlog(std::string(bytes), "wild.btlog", diagnostics);
  Diagnostics problems;
  const std::optional<Recording> run = FromBtlog(MakeLog(bytes), "log.btlog", problems);
  Require(run.has_value() != problems.has_errors());
  if (!run) return 0;
  for (std::size_t i = 0; i <= std::min<std::size_t>(run->ticks().size(), 50); ++i) {
    Require(run->Before(i).statuses.size() == run->trees().front().nodes.size());
  }
  ToCsv(*run);
  ToChromeTrace(*run);
  ToRosbag(*run, diagnostics);
  const std::optional<std::string> again = ToBtlog(*run, diagnostics);
  if (again) FromBtlog(*again, "again.btlog", diagnostics);
  return Reached(*run);
}

}  // namespace coppice::fuzz
