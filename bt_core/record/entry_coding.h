// Header, ticks, notes and gaps as payloads of frames, and back. The encoders read the running
// tree; the decoders make the values of entries.h. docs/record_format.md is the reference.
#ifndef COPPICE_BT_CORE_RECORD_ENTRY_CODING_H_
#define COPPICE_BT_CORE_RECORD_ENTRY_CODING_H_

#include <optional>
#include <string_view>

#include "bt_core/engine/executor.h"
#include "bt_core/history/coding.h"
#include "bt_core/record/entries.h"

namespace coppice {

/// Numbers, bool and string are coded without allocation; other types are printed.
void EncodeValue(const Value& value, Encoder& out);
void EncodeHeader(Executor& executor, const Metadata& metadata, Encoder& out);
void EncodeTick(const TickEvents& events, Encoder& out);
void EncodeNote(const RecordedNote& note, Encoder& out);
/// The numbers of the gap, with the state of the tree instead of the gap's own.
void EncodeGap(const RecordedGap& gap, const std::vector<Status>& statuses,
               const Blackboard& blackboard, Encoder& out);
void EncodeEnd(const RecordedEnd& end, Encoder& out);

/// Each returns nothing if the payload is not what it should be: too short, too long, a node that
/// there is not.
std::optional<RecordHeader> DecodeHeader(Decoder in);
std::optional<RecordedTick> DecodeTick(Decoder in, const RecordHeader& header);
std::optional<RecordedNote> DecodeNote(Decoder in);
std::optional<RecordedGap> DecodeGap(Decoder in, const RecordHeader& header);
std::optional<RecordedEnd> DecodeEnd(Decoder in);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_ENTRY_CODING_H_
