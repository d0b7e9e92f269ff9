#include <tiny_gltf.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "player/animation.hpp"
#include "scene/printable.hpp"

namespace pantin::player {
namespace {

double linear(float channel) { return std::pow(static_cast<double>(std::clamp(channel, 0.0f, 1.0f)), 2.2); }

template <std::size_t n>
std::vector<double> doubles(const std::array<float, n>& v) {
  return {v.begin(), v.end()};
}

/// Whether it is the same in every frame.
template <std::size_t n>
bool still(const std::vector<std::array<float, n>>& values) {
  return std::all_of(values.begin(), values.end(), [&](const auto& v) { return v == values.front(); });
}

}  // namespace

/// The glTF document: one buffer, with a view and an accessor for each array of numbers.
class Animation::File {
 public:
  File(const Animation& animation, const std::string& title) : from_(animation), frames_(animation.clock_.frames) {
    model_.asset.version = "2.0";
    model_.asset.generator = "Pantin";
    model_.buffers.emplace_back();
    model_.scenes.emplace_back().name = printable(title);
    model_.defaultScene = 0;
    for (const Mesh& mesh : from_.meshes_) add_mesh(mesh);
    if (frames_ > 1) model_.animations.emplace_back().name = printable(title);
    for (const Node& node : from_.nodes_) add_node(node);
    if (frames_ > 1 && model_.animations[0].channels.empty()) model_.animations.clear();
  }

  void write(const std::string& path) {
    std::ofstream file(path, std::ios::binary);
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, file, false, true);
    file.close();
    require(file.good(), "animation '", path, "' cannot be written: ", std::strerror(errno));
  }

 private:
  template <class Number>
  int add_numbers(const std::vector<Number>& numbers, int type, int target) {
    std::vector<unsigned char>& data = model_.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = numbers.size() * sizeof(Number);
    view.target = target;
    const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
    data.insert(data.end(), bytes, bytes + view.byteLength);
    model_.bufferViews.push_back(view);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    accessor.componentType =
        std::is_same_v<Number, float> ? TINYGLTF_COMPONENT_TYPE_FLOAT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.type = type;
    const auto parts = static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
    accessor.count = numbers.size() / parts;
    for (std::size_t k = 0; k < parts; k++) {
      accessor.minValues.push_back(static_cast<double>(numbers[k]));
      accessor.maxValues.push_back(static_cast<double>(numbers[k]));
    }
    for (std::size_t i = 0; i < numbers.size(); i++) {
      accessor.minValues[i % parts] = std::fmin(accessor.minValues[i % parts], static_cast<double>(numbers[i]));
      accessor.maxValues[i % parts] = std::fmax(accessor.maxValues[i % parts], static_cast<double>(numbers[i]));
    }
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  /// The texture of a picture, which is there as its file holds it.
  int texture(const std::shared_ptr<const Picture>& picture) {
    const auto [found, added] = textures_.try_emplace(picture, static_cast<int>(textures_.size()));
    if (!added) return found->second;
    std::vector<unsigned char>& data = model_.buffers[0].data;
    tinygltf::Image image;
    image.bufferView = static_cast<int>(model_.bufferViews.size());
    image.mimeType = picture->content.starts_with('\x89') ? "image/png" : "image/jpeg";
    image.name = printable(picture->file);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = picture->content.size();
    data.insert(data.end(), picture->content.begin(), picture->content.end());
    data.resize((data.size() + 3) / 4 * 4);  // numbers come after it
    model_.bufferViews.push_back(view);
    model_.images.push_back(image);
    model_.textures.emplace_back().source = found->second;
    return found->second;
  }

  int material(const Color& color, const std::shared_ptr<const Picture>& picture) {
    for (std::size_t i = 0; i < looks_.size(); i++)
      if (looks_[i].first == color && looks_[i].second == picture) return static_cast<int>(i);
    tinygltf::Material made;
    made.pbrMetallicRoughness.baseColorFactor = {linear(color.r), linear(color.g), linear(color.b),
                                                 static_cast<double>(color.a)};
    if (color.a < 1.0f) made.alphaMode = "BLEND";
    if (picture) made.pbrMetallicRoughness.baseColorTexture.index = texture(picture);
    made.pbrMetallicRoughness.metallicFactor = 0.0;
    made.pbrMetallicRoughness.roughnessFactor = 0.6;
    model_.materials.push_back(made);
    looks_.emplace_back(color, picture);
    return static_cast<int>(looks_.size()) - 1;
  }

  void add_mesh(const Mesh& mesh) {
    tinygltf::Mesh made;
    for (const Mesh::Patch& patch : mesh.patches) {
      tinygltf::Primitive primitive;
      primitive.mode = TINYGLTF_MODE_TRIANGLES;
      primitive.material = material(patch.color, patch.picture);
      primitive.attributes["POSITION"] = add_numbers(patch.positions, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
      primitive.attributes["NORMAL"] = add_numbers(patch.normals, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
      if (patch.picture)
        primitive.attributes["TEXCOORD_0"] =
            add_numbers(patch.places, TINYGLTF_TYPE_VEC2, TINYGLTF_TARGET_ARRAY_BUFFER);
      primitive.indices = add_numbers(patch.indices, TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
      made.primitives.push_back(primitive);
    }
    model_.meshes.push_back(made);
  }

  /// The accessor of the times of frames `first` to `last`, [s] of play.
  int times(std::uint64_t first, std::uint64_t last) {
    const auto [found, added] = times_.try_emplace({first, last}, 0);
    if (added) {
      std::vector<float> list;
      for (std::uint64_t k = first; k <= last; k++)
        list.push_back(static_cast<float>(static_cast<double>(k) / from_.clock_.rate));
      found->second = add_numbers(list, TINYGLTF_TYPE_SCALAR, 0);
    }
    return found->second;
  }

  template <std::size_t n>
  void add_channel(const char* path, int node, std::uint64_t first, const std::vector<std::array<float, n>>& values) {
    std::vector<float> numbers;
    for (const auto& v : values) numbers.insert(numbers.end(), v.begin(), v.end());
    tinygltf::AnimationSampler sampler;
    sampler.interpolation = "LINEAR";
    sampler.input = times(first, first + values.size() - 1);
    sampler.output = add_numbers(numbers, n == 3 ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_VEC4, 0);
    tinygltf::Animation& animation = model_.animations[0];
    animation.samplers.push_back(sampler);
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(animation.samplers.size()) - 1;
    channel.target_node = node;
    channel.target_path = path;
    animation.channels.push_back(channel);
  }

  void add_node(const Node& node) {
    tinygltf::Node made;
    made.name = printable(node.name);
    made.mesh = static_cast<int>(node.mesh);
    made.translation = doubles(node.positions.front());
    made.rotation = doubles(node.turns.front());
    made.scale = doubles(node.sizes.front());
    model_.nodes.push_back(made);
    const int index = static_cast<int>(model_.nodes.size()) - 1;
    model_.scenes[0].nodes.push_back(index);
    if (!still(node.positions)) add_channel("translation", index, node.first, node.positions);
    if (!still(node.turns)) add_channel("rotation", index, node.first, node.turns);
    const bool late = node.first > 0, gone = node.first + node.positions.size() < frames_;
    if (!late && !gone && still(node.sizes)) return;
    std::vector<std::array<float, 3>> sizes = node.sizes;
    if (late) sizes.insert(sizes.begin(), {0.0f, 0.0f, 0.0f});
    if (gone) sizes.push_back({0.0f, 0.0f, 0.0f});
    add_channel("scale", index, late ? node.first - 1 : 0, sizes);
  }

  const Animation& from_;
  std::uint64_t frames_;
  tinygltf::Model model_;
  std::vector<std::pair<Color, std::shared_ptr<const Picture>>> looks_;  // of the materials
  std::map<std::shared_ptr<const Picture>, int> textures_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, int> times_;  // accessors, by first and last frame
};

void Animation::write(const std::string& path, const std::string& title) const { File(*this, title).write(path); }

}  // namespace pantin::player
