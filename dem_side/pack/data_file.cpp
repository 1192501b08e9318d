#include "data_file.hpp"

#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>
#include <stdexcept>

namespace slidewave::pack {

void write_data(std::string const& path, std::vector<Sphere> const& spheres, Bounds const& bounds,
                double density_kg_m3, int types) {
  std::ofstream file(path);
  file << "slidewave_pack: id type diameter density x y z\n\n"
       << spheres.size() << " atoms\n"
       << types << " atom types\n\n";
  char const* const axes[] = {"x", "y", "z"};
  file << std::setprecision(12);
  for (int d = 0; d < 3; ++d) {
    file << bounds.low[d] << ' ' << bounds.high[d] << ' ' << axes[d] << "lo " << axes[d] << "hi\n";
  }
  file << "\nAtoms\n\n";
  long id = 0;
  for (auto const& s : spheres) {
    file << ++id << " 1 " << 2 * s.radius << ' ' << density_kg_m3 << ' ' << s.x << ' ' << s.y << ' '
         << s.z << '\n';
  }
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

std::vector<Sphere> read_dump(std::string const& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::vector<Sphere> spheres;
  long count = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("ITEM: NUMBER OF ATOMS", 0) == 0) {
      std::getline(file, line);
      count = std::stol(line);
    } else if (line.rfind("ITEM: ATOMS", 0) == 0) {
      std::istringstream names(line.substr(11));
      std::map<std::string, std::size_t> column;
      for (std::string name; names >> name;) column.emplace(name, column.size());
      for (auto const* needed : {"x", "y", "z", "radius"}) {
        if (!column.count(needed)) {
          throw std::runtime_error(path + ": the dump has no column " + needed);
        }
      }
      spheres.clear();
      std::vector<double> row(column.size());
      for (long i = 0; i < count; ++i) {
        for (auto& value : row) file >> value;
        spheres.push_back(
            {row[column["x"]], row[column["y"]], row[column["z"]], row[column["radius"]]});
      }
      if (!file) throw std::runtime_error(path + ": the last snapshot is not complete");
      std::getline(file, line);
    }
  }
  if (spheres.empty()) throw std::runtime_error(path + ": holds no particles");
  return spheres;
}

}  // namespace slidewave::pack
