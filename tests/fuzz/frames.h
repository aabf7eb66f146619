// Frames of a history as bytes that a fuzzer can change without breaking sums and sizes: for each
// its type (1 byte), the size of its payload (2 bytes, little endian) and the payload, unpacked.
#ifndef COPPICE_TESTS_FUZZ_FRAMES_H_
#define COPPICE_TESTS_FUZZ_FRAMES_H_

#include <string>
#include <string_view>

#include "bt_core/frames/frame.h"
#include "bt_core/frames/packer.h"

namespace coppice::fuzz {

struct LooseFrame {
  unsigned char type = 0;
  std::string_view payload;
};

/// Takes the first frame off; false if nothing is left.
bool TakeFrame(std::string_view& bytes, LooseFrame& frame);

void AppendFrame(unsigned char type, std::string_view payload, std::string& out);

/// The frame as the decoder gets it, whole.
Bytes Seal(const LooseFrame& frame, Packer& packer);

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_FRAMES_H_
