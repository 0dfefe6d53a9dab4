#include "Gltf_elements.h"

#include "byte_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace gltf {

namespace {

enum Component_type { BYTE = 5120, UNSIGNED_BYTE, SHORT, UNSIGNED_SHORT, UNSIGNED_INT = 5125, FLOAT };

std::size_t size_of(int component_type)
{
  switch(component_type)
  {
    case BYTE:
    case UNSIGNED_BYTE: return 1;
    case SHORT:
    case UNSIGNED_SHORT: return 2;
    case UNSIGNED_INT:
    case FLOAT: return 4;
    default: return 0;
  }
}

struct Type
{
  const char* name;
  int rows, columns;
};

constexpr std::array<Type, 7> types
  = {{{"SCALAR", 1, 1}, {"VEC2", 2, 1}, {"VEC3", 3, 1}, {"VEC4", 4, 1}, {"MAT2", 2, 2}, {"MAT3", 3, 3}, {"MAT4", 4, 4}}};

std::size_t next_multiple_of_four(std::size_t size) { return (size + 3) / 4 * 4; }

} // namespace

Elements::Elements(const Document& document, std::size_t index)
  : m_accessor(index)
{
  const Json& accessor = item(document.description(), "accessors", index);
  read_type(accessor);
  m_number = number_or(accessor, "count", 0);
  const Json* const sparse = find(accessor, "sparse");
  if(find(accessor, "bufferView") != nullptr)
  {
    const std::size_t stride
      = number_or(item(document.description(), "bufferViews", number_or(accessor, "bufferView", 0)), "byteStride", 0);
    m_stride = stride == 0 ? m_own_stride : stride;
    m_bytes = checked(document, accessor, m_size, m_stride, m_number);
  }
  else
  {
    constexpr std::size_t most_zeros = 1 << 24; // no bytes of the file account for them
    if(m_number > most_zeros / m_stride)
      fail_about("has too many elements for one without a view of a buffer");
    m_own_bytes = std::make_shared<std::string>(m_number * m_stride, '\0');
    m_bytes = *m_own_bytes;
  }
  if(sparse != nullptr)
    replace_sparse(document, *sparse);
}

void Elements::read_type(const Json& accessor)
{
  m_component_type = int(number_or(accessor, "componentType", 0));
  m_component_size = size_of(m_component_type);
  const std::string name = text_of(accessor, "type");
  const auto type = std::find_if(types.begin(), types.end(), [&](const Type& t) { return t.name == name; });
  if(m_component_size == 0 || type == types.end())
    fail_about("has no valid type");
  const std::size_t column = std::size_t(type->rows) * m_component_size; // those of matrices begin at multiples of four
  m_number_of_components = type->rows * type->columns;
  m_size = std::size_t(type->columns - 1) * next_multiple_of_four(column) + column;
  m_own_stride = m_stride = type->columns == 1 ? m_size : next_multiple_of_four(m_size);
  const Json* const normalized = find(accessor, "normalized");
  m_is_normalized = normalized != nullptr && normalized->is_boolean() && normalized->get<bool>();
}

// The bytes from the first element on to which `object` refers.
std::string_view Elements::checked(const Document& document, const Json& object, std::size_t size, std::size_t stride,
                                   std::size_t number) const
{
  const std::string_view bytes = document.view(number_or(object, "bufferView", SIZE_MAX));
  const std::size_t first = number_or(object, "byteOffset", 0);
  if(stride < size)
    fail_about("has elements that overlap");
  if(first > bytes.size()
     || (number > 0 && (bytes.size() - first < size || (bytes.size() - first - size) / stride < number - 1)))
    fail_about("reaches beyond its view of a buffer");
  return bytes.substr(first);
}

void Elements::replace_sparse(const Document& document, const Json& sparse)
{
  const std::size_t number = number_or(sparse, "count", 0);
  const Json *const indices = find(sparse, "indices"), *const values = find(sparse, "values");
  const int index_type = indices == nullptr ? 0 : int(number_or(*indices, "componentType", 0));
  const std::size_t index_size = size_of(index_type);
  if(values == nullptr || index_size == 0 || number > m_number)
    fail_about("has no valid sparse elements");
  const std::string_view index_bytes = checked(document, *indices, index_size, index_size, number);
  const std::string_view value_bytes = checked(document, *values, m_size, m_own_stride, number);

  auto own = std::make_shared<std::string>();
  for(std::size_t i = 0; i < m_number; ++i)
    own->append(bytes(i));
  for(std::size_t i = 0; i < number; ++i)
  {
    const std::string_view at = index_bytes.substr(i * index_size);
    const std::size_t index = index_size == 1 ? load<std::uint8_t>(at, false)
                            : index_size == 2 ? load<std::uint16_t>(at, false) : load<std::uint32_t>(at, false);
    if(index >= m_number)
      fail_about("has a sparse element number " + std::to_string(index) + " of " + std::to_string(m_number));
    std::copy_n(value_bytes.begin() + std::ptrdiff_t(i * m_own_stride), m_size, own->begin() + std::ptrdiff_t(index * m_size));
  }
  m_own_bytes = own;
  m_bytes = *m_own_bytes;
  m_stride = m_size;
}

bool Elements::has_indices() const
{
  return m_number_of_components == 1 && (m_component_type == UNSIGNED_BYTE || m_component_type == UNSIGNED_SHORT
                                         || m_component_type == UNSIGNED_INT);
}

std::size_t Elements::index(std::size_t i) const
{
  const std::string_view at = m_bytes.substr(i * m_stride);
  return m_component_size == 1 ? load<std::uint8_t>(at, false)
       : m_component_size == 2 ? load<std::uint16_t>(at, false) : load<std::uint32_t>(at, false);
}

double Elements::component(std::size_t i, int k) const
{
  const std::string_view at = m_bytes.substr(i * m_stride + std::size_t(k) * m_component_size);
  const auto fraction = [&](double number, double largest)
  { return m_is_normalized ? (std::max)(number / largest, -1.) : number; };
  switch(m_component_type)
  {
    case BYTE: return fraction(load<std::int8_t>(at, false), 127);
    case UNSIGNED_BYTE: return fraction(load<std::uint8_t>(at, false), 255);
    case SHORT: return fraction(load<std::int16_t>(at, false), 32767);
    case UNSIGNED_SHORT: return fraction(load<std::uint16_t>(at, false), 65535);
    case UNSIGNED_INT: return load<std::uint32_t>(at, false);
    default: return load<float>(at, false);
  }
}

void Elements::fail_about(const std::string& reason) const
{
  fail("damaged glTF: accessor " + std::to_string(m_accessor) + " " + reason);
}

} // namespace gltf
