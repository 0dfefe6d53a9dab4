// What accessors of a glTF file refer to.

#ifndef UNWRAP_GLTF_ELEMENTS_H
#define UNWRAP_GLTF_ELEMENTS_H

#include "byte_order.h"
#include "outcome.h"

#include <tiny_gltf.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gltf {

[[noreturn]] inline void fail(const std::string& reason) { throw Failure(Exit_code::UNREADABLE, reason); }

template <typename Item>
const Item& at(const std::vector<Item>& items, int index, const char* what)
{
  if(index < 0 || index >= int(items.size()))
    fail(std::string("the file refers to a ") + what + " that it does not have");
  return items[std::size_t(index)];
}

// The elements of an accessor, one after the other.
class Elements
{
public:
  Elements(const tinygltf::Model& model, int accessor)
    : m_accessor(at(model.accessors, accessor, "accessor"))
  {
    if(m_accessor.sparse.isSparse)
      fail("sparse accessors are not supported");
    const tinygltf::BufferView& view = at(model.bufferViews, m_accessor.bufferView, "view of a buffer");
    const std::vector<unsigned char>& data = at(model.buffers, view.buffer, "buffer").data;
    const int stride = m_accessor.ByteStride(view);
    const int size = tinygltf::GetComponentSizeInBytes(std::uint32_t(m_accessor.componentType))
                     * tinygltf::GetNumComponentsInType(std::uint32_t(m_accessor.type));
    if(size <= 0 || stride < size)
      fail("an accessor has no valid type");
    m_stride = std::size_t(stride);
    const std::size_t first = view.byteOffset + m_accessor.byteOffset;
    if(first > data.size() || (m_accessor.count > 0 && (data.size() - first < std::size_t(size) ||
                               (data.size() - first - std::size_t(size)) / m_stride < m_accessor.count - 1)))
      fail("the file ends before the last element of an accessor");
    m_bytes = std::string_view(reinterpret_cast<const char*>(data.data()), data.size()).substr(first);
  }

  std::size_t number() const { return m_accessor.count; }
  bool is(int component_type, int type) const
  {
    return m_accessor.componentType == component_type && m_accessor.type == type;
  }

  // Of one of the component types that may stand for fractions.
  bool has_fractions(int type) const
  {
    return is(TINYGLTF_COMPONENT_TYPE_FLOAT, type) || is(TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, type)
           || is(TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, type);
  }

  int index(std::size_t i) const
  {
    const std::string_view bytes = m_bytes.substr(i * m_stride);
    if(is(TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR))
      return int((std::min)(load<std::uint32_t>(bytes, false), std::uint32_t(INT32_MAX)));
    if(is(TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR))
      return load<std::uint16_t>(bytes, false);
    if(is(TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_TYPE_SCALAR))
      return load<std::uint8_t>(bytes, false);
    fail("indices of triangles are not numbers without a sign");
  }

  // The first numbers of an element; whole ones are fractions of the largest.
  template <int number>
  Eigen::Matrix<double, number, 1> vector(std::size_t i) const
  {
    const std::string_view bytes = m_bytes.substr(i * m_stride);
    Eigen::Matrix<double, number, 1> result;
    for(int k = 0; k < number; ++k)
      result[k] = m_accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT ? load<float>(bytes.substr(4 * k), false)
                : m_accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
                    ? load<std::uint16_t>(bytes.substr(2 * k), false) / 65535.
                    : load<std::uint8_t>(bytes.substr(k), false) / 255.;
    return result;
  }

private:
  const tinygltf::Accessor& m_accessor;
  std::size_t m_stride = 0;
  std::string_view m_bytes;
};

} // namespace gltf

#endif // UNWRAP_GLTF_ELEMENTS_H
