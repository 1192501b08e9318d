#include "Gauge.H"
#include "Observer.H"
#include "Wave.H"

namespace slidewave::foam {

std::vector<std::unique_ptr<Observer>> makeObservers(Scene const& scene, Foam::fvMesh const& mesh) {
  std::vector<std::unique_ptr<Observer>> observers;
  if (!scene.has("observe")) return observers;
  for (std::string const& name : scene.keys("observe")) {
    std::string const table = "observe." + name;
    std::string const type = scene.text(table + ".type");
    if (type == "wave") observers.push_back(std::make_unique<Wave>(scene, name));
    if (type == "gauge") observers.push_back(std::make_unique<Gauge>(scene, name, mesh));
  }
  return observers;
}

}  // namespace slidewave::foam
