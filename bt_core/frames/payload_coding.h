// Descriptions and states as payloads of frames, and back. docs/record_format.md is the reference.
#ifndef COPPICE_BT_CORE_FRAMES_PAYLOAD_CODING_H_
#define COPPICE_BT_CORE_FRAMES_PAYLOAD_CODING_H_

#include <optional>
#include <string>

#include "bt_core/frames/coding.h"
#include "bt_core/frames/history.h"
#include "bt_core/frames/tick_coding.h"

namespace coppice {

void EncodeTree(const TreeDescription& tree, Encoder& out);
/// Nothing if the bytes are no description.
std::optional<TreeDescription> DecodeTree(Decoder in);

/// What a reader wants to know of a state without unpacking it: cause, tick and time.
void EncodeStateHead(const HistoryState& state, Encoder& out);
/// Everything else is as it was in `state`. False if the bytes are no such head.
bool DecodeStateHead(Decoder& in, HistoryState& state);

void EncodeStateBody(const HistoryState& state, Encoder& out);
/// Of a tree of that size. False if the bytes are no such body.
bool DecodeStateBody(Decoder in, const TreeSize& size, HistoryState& state);

void EncodeGap(const HistoryGap& gap, Encoder& out);
std::optional<HistoryGap> DecodeGap(Decoder in);
/// The whole frame that says what is missing.
std::string MakeGapFrame(const HistoryGap& gap);

void EncodeNote(const HistoryNote& note, Encoder& out);
std::optional<HistoryNote> DecodeNote(Decoder in);

void EncodeEnd(const HistoryEnd& end, Encoder& out);
std::optional<HistoryEnd> DecodeEnd(Decoder in);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_PAYLOAD_CODING_H_
