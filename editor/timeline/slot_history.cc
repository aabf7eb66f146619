#include "editor/timeline/slot_history.h"

#include <algorithm>
#include <variant>

#include "bt_core/data/value_bytes.h"

namespace coppice::editor {

std::size_t WritesUpTo(const std::vector<SlotWrite>& writes, std::size_t tick) {
  const auto behind =
      std::upper_bound(writes.begin(), writes.end(), tick,
                       [](std::size_t t, const SlotWrite& write) { return t < write.tick; });
  return static_cast<std::size_t>(behind - writes.begin());
}

const SlotWrite* LastWriteOf(const Run& run, SlotIndex slot, std::size_t tick) {
  const std::vector<SlotWrite>& writes = run.TracksAt(tick).WritesOf(slot);
  const std::size_t count = WritesUpTo(writes, tick);
  if (count == 0) return nullptr;
  const SlotWrite& last = writes[count - 1];
  const bool is_of_another_run =
      std::any_of(run.breaks().begin(), run.breaks().end(), [&](const RunBreak& at) {
        return at.is_other_run && at.tick > last.tick && at.tick <= tick;
      });
  return is_of_another_run ? nullptr : &last;
}

std::string WriterOf(const Run& run, const SlotWrite& write) {
  const Event event = run.EventAt(write);
  const auto& nodes = run.TracksAt(write.tick).tree()->nodes;
  if (event.code == EventCode::kDelivery) return "from outside";
  return event.writer < nodes.size() ? nodes[event.writer].path : "not known by whom";
}

std::string ValueOf(const Run& run, const SlotWrite& write) {
  constexpr std::size_t kMostBytes = 200;  // a row has room for less
  const std::string_view bytes = run.EventAt(write).bytes;
  const ValueForm form = FormOfValue(bytes);
  const bool is_text = form == ValueForm::kText || form == ValueForm::kJson;
  if (!is_text || bytes.size() <= kMostBytes) return PrintValueBytes(bytes);
  std::size_t end = kMostBytes;
  while (end > 1 && (static_cast<unsigned char>(bytes[end]) & 0xC0U) == 0x80U) --end;
  return PrintValueBytes(bytes.substr(0, end)) + " ...";
}

std::optional<double> NumberOf(std::string_view bytes) {
  const ValueForm form = FormOfValue(bytes);
  if (form == ValueForm::kText || form == ValueForm::kJson) return std::nullopt;  // may be large
  const PlainValue value = ReadPlainValue(bytes);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? 1 : 0;
  if (const auto* number = std::get_if<std::int64_t>(&value)) return static_cast<double>(*number);
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*number);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

std::vector<std::optional<double>> SampleSlot(const Run& run, SlotIndex slot,
                                              const std::vector<std::size_t>& ticks) {
  std::vector<std::optional<double>> samples(ticks.size());
  if (ticks.empty()) return samples;
  const Tracks& tracks = run.TracksAt(ticks.front());
  if (slot >= tracks.tree()->slots.size()) return samples;
  const std::vector<SlotWrite>& writes = tracks.WritesOf(slot);
  const auto& first_values = run.SectionAt(ticks.front()).state.values;
  const std::optional<double> first =
      slot < first_values.size() ? NumberOf(first_values[slot]) : std::nullopt;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const std::size_t count = WritesUpTo(writes, ticks[i]);
    samples[i] = count == 0 ? first : NumberOf(run.EventAt(writes[count - 1]).bytes);
  }
  return samples;
}

}  // namespace coppice::editor
