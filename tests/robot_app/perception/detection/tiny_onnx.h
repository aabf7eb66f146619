// ONNX files of a few kilobytes, written byte by byte (Protocol Buffers, onnx.proto3): networks
// that see somebody in the cells of a picture that are red.
#ifndef COPPICE_TESTS_ROBOT_APP_PERCEPTION_DETECTION_TINY_ONNX_H_
#define COPPICE_TESTS_ROBOT_APP_PERCEPTION_DETECTION_TINY_ONNX_H_

#include <cstdint>
#include <string>
#include <vector>

namespace coppice::robot::perception {

/// A message of Protocol Buffers.
class ProtoMessage {
 public:
  ProtoMessage& Number(int field, std::uint64_t value) {
    Varint(static_cast<std::uint64_t>(field) << 3);
    Varint(value);
    return *this;
  }
  ProtoMessage& Text(int field, const std::string& text) {
    Varint(static_cast<std::uint64_t>(field) << 3 | 2);
    Varint(text.size());
    bytes += text;
    return *this;
  }
  ProtoMessage& Part(int field, const ProtoMessage& part) { return Text(field, part.bytes); }

  std::string bytes;

 private:
  void Varint(std::uint64_t value) {
    for (; value >= 128; value >>= 7) bytes += static_cast<char>((value & 127) | 128);
    bytes += static_cast<char>(value);
  }
};

/// The square of such a network [pixels], its cells along each side, and the size of a cell.
inline constexpr int kTinySquare = 128;
inline constexpr int kTinyCells = 4;
inline constexpr int kTinyCell = kTinySquare / kTinyCells;

namespace tiny_onnx {

using Sizes = std::vector<std::uint64_t>;

template <typename T>
ProtoMessage Tensor(const std::string& name, int type, const Sizes& sizes,
                    const std::vector<T>& numbers) {
  ProtoMessage tensor;
  for (const std::uint64_t size : sizes) tensor.Number(1, size);
  tensor.Number(2, static_cast<std::uint64_t>(type)).Text(8, name);
  return tensor.Text(9,
                     {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)});
}

inline ProtoMessage Floats(const std::string& name, const Sizes& sizes,
                           const std::vector<float>& numbers) {
  return Tensor(name, 1, sizes, numbers);
}

inline ProtoMessage Value(const std::string& name, const Sizes& sizes) {
  ProtoMessage shape;
  for (const std::uint64_t size : sizes) shape.Part(1, ProtoMessage().Number(1, size));
  const ProtoMessage tensor = ProtoMessage().Number(1, 1).Part(2, shape);
  return ProtoMessage().Text(1, name).Part(2, ProtoMessage().Part(1, tensor));
}

inline ProtoMessage Node(const std::string& operation, const std::vector<std::string>& inputs,
                         const std::string& output) {
  ProtoMessage node;
  for (const std::string& input : inputs) node.Text(1, input);
  return node.Text(2, output).Text(3, operation + "_" + output).Text(4, operation);
}

inline ProtoMessage Attribute(const std::string& name, const Sizes& numbers) {
  ProtoMessage attribute;
  attribute.Text(1, name).Number(20, 7);
  for (const std::uint64_t number : numbers) attribute.Number(8, number);
  return attribute;
}

/// Where each cell is: middle and size, in pixels; one row of numbers for each of them.
inline std::vector<float> Grid(int rows) {
  constexpr int kAll = kTinyCells * kTinyCells;
  std::vector<float> grid(static_cast<std::size_t>(rows) * kAll);
  for (int cell = 0; cell < kAll; ++cell) {
    grid[cell] = (static_cast<float>(cell % kTinyCells) + 0.5F) * kTinyCell;
    grid[kAll + cell] = (static_cast<float>(cell / kTinyCells) + 0.5F) * kTinyCell;
    grid[2 * kAll + cell] = grid[3 * kAll + cell] = kTinyCell;
  }
  return grid;
}

}  // namespace tiny_onnx

/// Of one class. With `rows` the layout of YOLOv5: 1 x boxes x (x, y, width, height, something
/// there, class); else that of YOLOv8: 1 x (x, y, width, height, class) x boxes.
inline std::string TinyOnnx(bool rows) {
  using namespace tiny_onnx;
  constexpr std::uint64_t kBoxes = kTinyCells * kTinyCells;
  const std::uint64_t numbers = rows ? 6 : 5;
  // How red a cell is, from 0 to 1, in all numbers but the box.
  std::vector<float> weights(numbers * 3 * kTinyCell * kTinyCell);
  for (std::uint64_t i = 4; i < numbers; ++i) {
    for (int k = 0; k < kTinyCell * kTinyCell; ++k) {
      weights[i * 3 * kTinyCell * kTinyCell + k] = 1.0F / (kTinyCell * kTinyCell);
    }
  }
  ProtoMessage graph;
  graph.Part(1, Node("Conv", {"picture", "weights"}, "red")
                    .Part(5, Attribute("kernel_shape", {kTinyCell, kTinyCell}))
                    .Part(5, Attribute("strides", {kTinyCell, kTinyCell})));
  graph.Part(1, Node("Reshape", {"red", "sizes"}, "flat"));
  graph.Part(1, Node("Add", {"flat", "grid"}, rows ? "columns" : "boxes"));
  if (rows) {
    graph.Part(1, Node("Transpose", {"columns"}, "boxes").Part(5, Attribute("perm", {0, 2, 1})));
  }
  graph.Text(2, "tiny");
  graph.Part(5, Floats("weights", {numbers, 3, kTinyCell, kTinyCell}, weights));
  graph.Part(5, Tensor<std::int64_t>("sizes", 7, {3}, {1, std::int64_t(numbers), kBoxes}));
  graph.Part(5, Floats("grid", {1, numbers, kBoxes}, Grid(static_cast<int>(numbers))));
  graph.Part(11, Value("picture", {1, 3, kTinySquare, kTinySquare}));
  graph.Part(12,
             rows ? Value("boxes", {1, kBoxes, numbers}) : Value("boxes", {1, numbers, kBoxes}));
  return ProtoMessage()
      .Number(1, 7)
      .Part(7, graph)
      .Part(8, ProtoMessage().Text(1, "").Number(2, 11))
      .bytes;
}

}  // namespace coppice::robot::perception

#endif  // COPPICE_TESTS_ROBOT_APP_PERCEPTION_DETECTION_TINY_ONNX_H_
