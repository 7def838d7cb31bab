#include "trace/hdf5_internal.hpp"

namespace fingerpad::hdf5 {
namespace {

Handle text_type(const std::string& path) {
  Handle type = made(H5Tcopy(H5T_C_S1), H5Tclose, path);
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

void write_attribute(const Handle& object, const std::string& name, hid_t type, hid_t memory_type,
                     const Handle& space, const void* values) {
  const Handle attribute = wrapped(
      H5Acreate2(object.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "");
  if (!attribute.open() || H5Awrite(attribute.id(), memory_type, values) < 0) {
    throw write_error(object.path(), name);
  }
}

/// An attribute of numbers that holds exactly `count`.
Handle open_attribute(const Handle& object, const std::string& name, std::size_t count) {
  Handle attribute = wrapped(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), H5Aclose, object.path());
  if (!attribute.open()) throw read_error(object.path(), name);
  const Handle space = wrapped(H5Aget_space(attribute.id()), H5Sclose, "");
  const Handle type = wrapped(H5Aget_type(attribute.id()), H5Tclose, "");
  const H5T_class_t kind = H5Tget_class(type.id());
  if (H5Sget_simple_extent_npoints(space.id()) != static_cast<hssize_t>(count) ||
      (kind != H5T_INTEGER && kind != H5T_FLOAT) || H5Tget_size(type.id()) > sizeof(double)) {
    throw read_error(object.path(), name);
  }
  return attribute;
}

constexpr hssize_t max_texts = 100000;
constexpr std::size_t max_padded_bytes = std::size_t{1} << 20;

/// Texts that have one length in the file, padded with zeros or blanks, as NumPy's bytes and MATLAB's have.
std::vector<std::string> read_padded_texts(const Handle& attribute, const Handle& type, std::size_t count) {
  const std::size_t bytes = H5Tget_size(type.id());
  if (bytes == 0 || count > max_padded_bytes / bytes) throw read_error(attribute.path(), "an attribute");
  const Handle memory_type = made(H5Tcopy(type.id()), H5Tclose, attribute.path());
  std::vector<char> room(bytes * count);
  if (H5Aread(attribute.id(), memory_type.id(), room.data()) < 0)
    throw read_error(attribute.path(), "an attribute");
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string padded(room.data() + i * bytes, bytes);
    const std::string whole = padded.substr(0, padded.find('\0'));
    texts.push_back(whole.substr(0, whole.find_last_not_of(' ') + 1));
  }
  return texts;
}

}  // namespace

void write_text(const Handle& object, const std::string& name, const std::string& text) {
  const Turn turn;
  const Handle type = text_type(object.path());
  const Handle space = made(H5Screate(H5S_SCALAR), H5Sclose, object.path());
  const char* value = text.c_str();
  write_attribute(object, name, type.id(), type.id(), space, static_cast<const void*>(&value));
}

void write_texts(const Handle& object, const std::string& name, const std::vector<std::string>& texts) {
  const Turn turn;
  if (texts.empty()) return;
  const Handle type = text_type(object.path());
  const hsize_t count = texts.size();
  const Handle space = made(H5Screate_simple(1, &count, nullptr), H5Sclose, object.path());
  std::vector<const char*> values;
  values.reserve(texts.size());
  for (const std::string& text : texts) values.push_back(text.c_str());
  write_attribute(object, name, type.id(), type.id(), space, static_cast<const void*>(values.data()));
}

void write_flag(const Handle& object, const std::string& name, bool flag) {
  const Turn turn;
  const auto value = static_cast<std::uint8_t>(flag);
  if (!has_attribute(object, name)) {
    const Handle space = made(H5Screate(H5S_SCALAR), H5Sclose, object.path());
    write_attribute(object, name, H5T_STD_U8LE, H5T_NATIVE_UINT8, space, &value);
    return;
  }
  const Handle attribute = open_attribute(object, name, 1);
  if (H5Awrite(attribute.id(), H5T_NATIVE_UINT8, &value) < 0) throw write_error(object.path(), name);
}

void write_whole(const Handle& object, const std::string& name, std::uint64_t value) {
  const Turn turn;
  const Handle space = made(H5Screate(H5S_SCALAR), H5Sclose, object.path());
  write_attribute(object, name, H5T_STD_U64LE, H5T_NATIVE_UINT64, space, &value);
}

void write_numbers(const Handle& object, const std::string& name, std::span<const double> values) {
  const Turn turn;
  const hsize_t count = values.size();
  const Handle space = made(count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr),
                            H5Sclose, object.path());
  write_attribute(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, space, values.data());
}

bool has_attribute(const Handle& object, const std::string& name) {
  const Turn turn;
  return H5Aexists(object.id(), name.c_str()) > 0;
}

std::vector<std::string> read_texts(const Handle& object, const std::string& name) {
  const Turn turn;
  if (!has_attribute(object, name)) return {};
  const Handle attribute = wrapped(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), H5Aclose, object.path());
  if (!attribute.open()) throw read_error(object.path(), name);
  const Handle space = wrapped(H5Aget_space(attribute.id()), H5Sclose, "");
  const Handle type = wrapped(H5Aget_type(attribute.id()), H5Tclose, "");
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  if (H5Tget_class(type.id()) != H5T_STRING || count < 0 || count > max_texts)
    throw read_error(object.path(), name);
  if (H5Tis_variable_str(type.id()) <= 0)
    return read_padded_texts(attribute, type, static_cast<std::size_t>(count));

  const Handle memory_type = text_type(object.path());
  H5Tset_cset(memory_type.id(), H5Tget_cset(type.id()));
  std::vector<char*> values(static_cast<std::size_t>(count), nullptr);
  if (H5Aread(attribute.id(), memory_type.id(), static_cast<void*>(values.data())) < 0) {
    throw read_error(object.path(), name);
  }
  std::vector<std::string> texts;
  for (char* value : values) {
    texts.emplace_back(value != nullptr ? value : "");
    H5free_memory(value);
  }
  return texts;
}

std::string read_text(const Handle& object, const std::string& name) {
  const Turn turn;
  const std::vector<std::string> texts = read_texts(object, name);
  return texts.size() == 1 ? texts.front() : "";
}

std::optional<std::uint64_t> read_whole(const Handle& object, const std::string& name) {
  const Turn turn;
  if (!has_attribute(object, name)) return std::nullopt;
  const Handle attribute = open_attribute(object, name, 1);
  std::uint64_t value = 0;
  if (H5Aread(attribute.id(), H5T_NATIVE_UINT64, &value) < 0) throw read_error(object.path(), name);
  return value;
}

std::vector<double> read_numbers(const Handle& object, const std::string& name, std::size_t count) {
  const Turn turn;
  const Handle attribute = open_attribute(object, name, count);
  std::vector<double> values(count);
  if (H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, values.data()) < 0) throw read_error(object.path(), name);
  return values;
}

}  // namespace fingerpad::hdf5
