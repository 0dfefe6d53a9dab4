// The elements to which an accessor of a glTF file refers.

#ifndef UNWRAP_GLTF_ELEMENTS_H
#define UNWRAP_GLTF_ELEMENTS_H

#include "Gltf_document.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace gltf {

// The elements of an accessor: in single precision or as whole numbers, one after the other or interleaved with others,
// some of them given apart. Fails if the file does not have them. Refers to the document.
class Elements
{
public:
  Elements(const Document& document, std::size_t accessor);

  std::size_t number() const { return m_number; }
  int number_of_components() const { return m_number_of_components; }

  // Those of an element, as they are.
  std::string_view bytes(std::size_t i) const { return m_bytes.substr(i * m_stride, m_size); }
  std::size_t size() const { return m_size; }

  // Whether they are whole numbers without a sign, which may be indices; and such a number.
  bool has_indices() const;
  std::size_t index(std::size_t i) const;

  // As a fraction where the accessor says that it is one.
  double component(std::size_t i, int k) const;

  // The first components.
  template <int number>
  Eigen::Matrix<double, number, 1> vector(std::size_t i) const
  {
    Eigen::Matrix<double, number, 1> result;
    for(int k = 0; k < number; ++k)
      result[k] = component(i, k);
    return result;
  }

private:
  void read_type(const Json& accessor);
  std::string_view checked(const Document& document, const Json& object, std::size_t size, std::size_t stride,
                           std::size_t number) const;
  void replace_sparse(const Document& document, const Json& sparse);
  [[noreturn]] void fail_about(const std::string& reason) const;

  std::size_t m_accessor, m_number = 0, m_size = 0, m_stride = 0;
  std::size_t m_own_stride = 0; // of elements one after the other
  int m_component_type = 0, m_number_of_components = 0;
  std::size_t m_component_size = 0;
  bool m_is_normalized = false;
  std::string_view m_bytes;
  std::shared_ptr<std::string> m_own_bytes; // where the file does not have them in one place
};

} // namespace gltf

#endif // UNWRAP_GLTF_ELEMENTS_H
