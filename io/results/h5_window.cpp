#include "io/results/h5_window.h"

#include <array>

#include "model/check.h"

namespace scree::io::h5 {

void window(const File& file, const std::string& name, const Rows& rows, const Label& label) {
  SCREE_ASSERT(rows.first >= 0 && rows.count > 0 && rows.width > 0);
  const std::string what = "make dataset " + name;
  const auto sure = [&](auto result) { return check(result, file.path(), what); };
  const int rank = rows.width == 1 ? 1 : 2;
  const auto width = static_cast<hsize_t>(rows.width);
  const std::array<hsize_t, 2> start{static_cast<hsize_t>(rows.first), 0};
  const std::array<hsize_t, 2> count{static_cast<hsize_t>(rows.count), width};
  // The dataspace of the mapping extends to the last of the rows: they may still be in our buffer.
  const std::array<hsize_t, 2> reach{start[0] + count[0], width}, limit{H5S_UNLIMITED, width};
  const Handle mapped(sure(H5Screate_simple(rank, reach.data(), limit.data())), H5Sclose);
  sure(H5Sselect_hyperslab(mapped.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
  const Handle shown(sure(H5Screate_simple(rank, count.data(), nullptr)), H5Sclose);

  const Handle list(sure(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
  sure(H5Pset_virtual(list.get(), shown.get(), ".", rows.dataset.c_str(), mapped.get()));
  const hid_t type = rows.whole ? type_of<std::int32_t>() : type_of<double>();
  Handle made(sure(H5Dcreate2(file.id(), name.c_str(), type, shown.get(), file.links(), list.get(), H5P_DEFAULT)),
              H5Dclose);
  file.label(made, name, label);
  if (!made.close()) fail(file.path(), what);
}

}  // namespace scree::io::h5
