// What became of a value over a run: who wrote it and when.
#ifndef COPPICE_EDITOR_TIMELINE_SLOT_HISTORY_H_
#define COPPICE_EDITOR_TIMELINE_SLOT_HISTORY_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "editor/timeline/run.h"

namespace coppice::editor {

/// Of Tracks::WritesOf: how many writes there are up to and with this tick.
std::size_t WritesUpTo(const std::vector<SlotWrite>& writes, std::size_t tick);

/// The write that the slot holds behind a tick; null: it holds what it had at the start of the
/// robot's program. `slot` is of the tree of that tick.
const SlotWrite* LastWriteOf(const Run& run, SlotIndex slot, std::size_t tick);

/// Path of the node that wrote, or "from outside" for what came through the inbox.
std::string WriterOf(const Run& run, const SlotWrite& write);

/// For people: what was written.
std::string ValueOf(const Run& run, const SlotWrite& write);

/// The number that bytes stand for (data/value_bytes.h); truths are 0 and 1. Nothing for the rest.
std::optional<double> NumberOf(std::string_view bytes);

/// The value as a number at each of these ticks, which rise; nothing where it is none. The slot is
/// one of the tree at the first of them.
std::vector<std::optional<double>> SampleSlot(const Run& run, SlotIndex slot,
                                              const std::vector<std::size_t>& ticks);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_TIMELINE_SLOT_HISTORY_H_
