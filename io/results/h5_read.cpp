#include "io/results/h5_read.h"

#include <array>

namespace scree::io::h5 {

namespace {

Handle open_dataset(const File& file, const std::string& name) {
  return {check(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), file.path(), "open dataset " + name), H5Dclose};
}

Handle open_attribute(const File& file, const std::string& name, const std::string& key) {
  return {check(H5Aopen_by_name(file.id(), name.c_str(), key.c_str(), H5P_DEFAULT, H5P_DEFAULT), file.path(),
                "open attribute " + key + " of " + name),
          H5Aclose};
}

Extent extent(const File& file, const std::string& name, hid_t dataset) {
  const Handle space(check(H5Dget_space(dataset), file.path(), "read " + name), H5Sclose);
  std::array<hsize_t, 2> size{0, 1};
  const int rank = check(H5Sget_simple_extent_ndims(space.get()), file.path(), "read " + name);
  if (rank < 1 || rank > 2) throw FileError(file.path(), name + " has not one or two dimensions");
  check(H5Sget_simple_extent_dims(space.get(), size.data(), nullptr), file.path(), "read " + name);
  return {static_cast<std::int64_t>(size[0]), static_cast<std::int64_t>(size[1])};
}

/// Frees texts that HDF5 allocated, also when copying them throws.
struct Texts {
  std::vector<char*> text;
  hid_t type, space;
  ~Texts() { (void)H5Dvlen_reclaim(type, space, H5P_DEFAULT, text.data()); }
};

herr_t list_dataset(hid_t, const char* name, const H5O_info_t* about, void* list) {
  if (about->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(list)->push_back(std::string("/") + name);
  return 0;
}

herr_t list_child(hid_t, const char* name, const H5L_info_t*, void* list) {
  static_cast<std::vector<std::string>*>(list)->emplace_back(name);
  return 0;
}

}  // namespace

Extent extent(const File& file, const std::string& name) { return extent(file, name, open_dataset(file, name).get()); }

template <class T>
std::vector<T> read(const File& file, const std::string& name, std::int64_t first, std::int64_t count) {
  const std::string what = "read " + name;
  const Handle dataset = open_dataset(file, name);
  const Extent size = extent(file, name, dataset.get());
  if (first < 0 || count < 0 || first + count > size.rows)
    throw FileError(file.path(),
                    name + " has fewer rows than the frames say; the run may have been killed while writing");
  std::vector<T> rows(static_cast<std::size_t>(count * size.width));
  if (rows.empty()) return rows;
  const Handle source(check(H5Dget_space(dataset.get()), file.path(), what), H5Sclose);
  const int rank = check(H5Sget_simple_extent_ndims(source.get()), file.path(), what);
  const std::array<hsize_t, 2> start{static_cast<hsize_t>(first), 0};
  const std::array<hsize_t, 2> block{static_cast<hsize_t>(count), static_cast<hsize_t>(size.width)};
  check(H5Sselect_hyperslab(source.get(), H5S_SELECT_SET, start.data(), nullptr, block.data(), nullptr), file.path(),
        what);
  const Handle memory(check(H5Screate_simple(rank, block.data(), nullptr), file.path(), what), H5Sclose);
  check(H5Dread(dataset.get(), type_of<T>(), memory.get(), source.get(), H5P_DEFAULT, rows.data()), file.path(), what);
  return rows;
}

template std::vector<double> read<double>(const File&, const std::string&, std::int64_t, std::int64_t);
template std::vector<std::int32_t> read<std::int32_t>(const File&, const std::string&, std::int64_t, std::int64_t);
template std::vector<std::int64_t> read<std::int64_t>(const File&, const std::string&, std::int64_t, std::int64_t);
template std::vector<std::uint64_t> read<std::uint64_t>(const File&, const std::string&, std::int64_t, std::int64_t);
template std::vector<std::uint8_t> read<std::uint8_t>(const File&, const std::string&, std::int64_t, std::int64_t);

std::vector<std::string> read_texts(const File& file, const std::string& name) {
  const Handle dataset = open_dataset(file, name);
  const std::int64_t rows = extent(file, name, dataset.get()).rows;
  if (rows == 0) return {};
  const Handle type = text_type(file.path());
  const Handle space(check(H5Dget_space(dataset.get()), file.path(), "read " + name), H5Sclose);
  Texts raw{std::vector<char*>(static_cast<std::size_t>(rows), nullptr), type.get(), space.get()};
  check(H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.text.data()), file.path(),
        "read " + name);
  std::vector<std::string> texts;
  for (const char* text : raw.text) texts.emplace_back(text == nullptr ? "" : text);
  return texts;
}

std::string text_attribute(const File& file, const std::string& name, const std::string& key) {
  const std::string what = "read attribute " + key + " of " + name;
  if (check(H5Aexists_by_name(file.id(), name.c_str(), key.c_str(), H5P_DEFAULT), file.path(), what) == 0) return {};
  const Handle attribute = open_attribute(file, name, key);
  const Handle stored(check(H5Aget_type(attribute.get()), file.path(), what), H5Tclose);
  if (check(H5Tis_variable_str(stored.get()), file.path(), what) == 0)
    throw FileError(file.path(), "cannot " + what + ": it is not text");
  const Handle type = text_type(file.path());
  const Handle space(check(H5Aget_space(attribute.get()), file.path(), what), H5Sclose);
  Texts raw{std::vector<char*>(1, nullptr), type.get(), space.get()};
  check(H5Aread(attribute.get(), type.get(), raw.text.data()), file.path(), what);
  return raw.text.front() == nullptr ? std::string() : std::string(raw.text.front());
}

std::int64_t integer_attribute(const File& file, const std::string& name, const std::string& key) {
  std::int64_t value = 0;
  check(H5Aread(open_attribute(file, name, key).get(), type_of<std::int64_t>(), &value), file.path(),
        "read attribute " + key + " of " + name);
  return value;
}

bool has_attribute(const File& file, const std::string& name, const std::string& key) {
  return check(H5Aexists_by_name(file.id(), name.c_str(), key.c_str(), H5P_DEFAULT), file.path(),
               "look for attribute " + key + " of " + name) > 0;
}

std::array<double, 2> pair_attribute(const File& file, const std::string& name, const std::string& key) {
  const std::string what = "read attribute " + key + " of " + name;
  std::array<double, 2> pair{0.0, 0.0};
  if (check(H5Aexists_by_name(file.id(), name.c_str(), key.c_str(), H5P_DEFAULT), file.path(), what) == 0) return pair;
  const Handle attribute = open_attribute(file, name, key);
  const Handle space(check(H5Aget_space(attribute.get()), file.path(), what), H5Sclose);
  if (check(H5Sget_simple_extent_npoints(space.get()), file.path(), what) != 2)
    throw FileError(file.path(), "cannot " + what + ": it is not a pair");
  check(H5Aread(attribute.get(), type_of<double>(), pair.data()), file.path(), what);
  return pair;
}

std::vector<std::string> datasets(const File& file) {
  std::vector<std::string> list;
  check(H5Ovisit2(file.id(), H5_INDEX_NAME, H5_ITER_INC, list_dataset, &list, H5O_INFO_BASIC), file.path(),
        "list the datasets");
  return list;
}

std::vector<std::string> children(const File& file, const std::string& group) {
  std::vector<std::string> list;
  const Handle opened(check(H5Gopen2(file.id(), group.c_str(), H5P_DEFAULT), file.path(), "open " + group), H5Gclose);
  check(H5Literate(opened.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, list_child, &list), file.path(), "list " + group);
  return list;
}

}  // namespace scree::io::h5
