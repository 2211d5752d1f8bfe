#include "io/results/h5_window.h"

#include <array>

#include "model/check.h"

namespace scree::io::h5 {

void window(const File& file, const std::string& name, const Rows& rows, const Label& label) {
  SCREE_ASSERT(rows.first >= 0 && rows.count > 0);
  const std::string what = "make dataset " + name;
  const auto sure = [&](auto result) { return check(result, file.path(), what); };
  const Handle source(sure(H5Dopen2(file.id(), rows.dataset.c_str(), H5P_DEFAULT)), H5Dclose);
  const Handle type(sure(H5Dget_type(source.get())), H5Tclose);
  const Handle source_space(sure(H5Dget_space(source.get())), H5Sclose);
  std::array<hsize_t, 2> size{0, 1}, limit{0, 1};
  const int rank = sure(H5Sget_simple_extent_ndims(source_space.get()));
  SCREE_ASSERT(rank == 1 || rank == 2);
  sure(H5Sget_simple_extent_dims(source_space.get(), size.data(), limit.data()));

  const std::array<hsize_t, 2> start{static_cast<hsize_t>(rows.first), 0};
  const std::array<hsize_t, 2> count{static_cast<hsize_t>(rows.count), size[1]};
  // The space of the mapping reaches as far as the rows do: they may be still in our buffer.
  const std::array<hsize_t, 2> reach{start[0] + count[0], size[1]};
  const Handle mapped(sure(H5Screate_simple(rank, reach.data(), limit.data())), H5Sclose);
  sure(H5Sselect_hyperslab(mapped.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
  const Handle shown(sure(H5Screate_simple(rank, count.data(), nullptr)), H5Sclose);

  const Handle list(sure(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
  sure(H5Pset_virtual(list.get(), shown.get(), ".", rows.dataset.c_str(), mapped.get()));
  if (const std::size_t slash = name.rfind('/'); slash != std::string::npos && slash > 0)
    file.group(name.substr(0, slash));
  Handle made(sure(H5Dcreate2(file.id(), name.c_str(), type.get(), shown.get(), H5P_DEFAULT, list.get(), H5P_DEFAULT)),
              H5Dclose);
  file.attribute(name, "units", label.units);
  file.attribute(name, "long_name", label.long_name);
  if (!made.close()) fail(file.path(), what);
}

}  // namespace scree::io::h5
