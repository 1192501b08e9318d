// Drag models by name, as a case chooses them: models.drag, models.drag_coefficient,
// models.formulation. To add a law, write its header and a line in `drag_laws` below.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "slidewave/physics/beetstra.hpp"
#include "slidewave/physics/brown_lawler.hpp"
#include "slidewave/physics/dalla_valle.hpp"
#include "slidewave/physics/di_felice.hpp"
#include "slidewave/physics/drag_batch.hpp"
#include "slidewave/physics/ergun.hpp"
#include "slidewave/physics/gidaspow.hpp"
#include "slidewave/physics/koch_hill.hpp"
#include "slidewave/physics/nearest_name.hpp"
#include "slidewave/physics/rong.hpp"
#include "slidewave/physics/schiller_naumann.hpp"
#include "slidewave/physics/single_sphere.hpp"
#include "slidewave/physics/stokes.hpp"
#include "slidewave/physics/wen_yu.hpp"

namespace slidewave {

using DragKernel = void (*)(DragInputs const&, Formulation, Eigen::Ref<Eigen::MatrixXd>);

/// A model ready to be evaluated; its names are those of the case, for logs and summaries.
struct DragModel {
  std::string law;
  std::string coefficient;  ///< "" where the law has its own
  Formulation formulation = Formulation::A;
  DragKernel kernel = nullptr;
};

/// A law, or a law with a single-sphere coefficient, and its kernel.
struct DragLawEntry {
  char const* law;
  char const* coefficient;  ///< "" where the law has its own
  DragKernel kernel;
};

template <class Law>
DragLawEntry drag_law_entry(char const* coefficient) {
  return {Law::name, coefficient, drag_coefficients_of<Law>};
}

template <template <class> class Law>
void add_with_coefficients(std::vector<DragLawEntry>& entries) {
  entries.push_back(drag_law_entry<Law<BrownLawler>>(BrownLawler::name));
  entries.push_back(drag_law_entry<Law<DallaValle>>(DallaValle::name));
  entries.push_back(drag_law_entry<Law<SchillerNaumann>>(SchillerNaumann::name));
  entries.push_back(drag_law_entry<Law<Stokes>>(Stokes::name));
}

inline std::vector<DragLawEntry> const& drag_laws() {
  static std::vector<DragLawEntry> const entries = [] {
    std::vector<DragLawEntry> list;
    add_with_coefficients<DiFelice>(list);
    add_with_coefficients<Rong>(list);
    add_with_coefficients<SingleSphere>(list);
    list.push_back(drag_law_entry<Ergun>(""));
    list.push_back(drag_law_entry<WenYu>(""));
    list.push_back(drag_law_entry<Gidaspow>(""));
    list.push_back(drag_law_entry<KochHill>(""));
    list.push_back(drag_law_entry<Beetstra>(""));
    return list;
  }();
  return entries;
}

/// Names for models.drag, each once. "none" (no drag at all) is the caller's.
inline std::vector<std::string> drag_law_names() {
  std::vector<std::string> names;
  for (auto const& entry : drag_laws()) {
    if (names.empty() || names.back() != entry.law) {
      names.emplace_back(entry.law);
    }
  }
  return names;
}

/// Names for models.drag_coefficient.
inline std::vector<std::string> drag_coefficient_names() {
  return {BrownLawler::name, DallaValle::name, SchillerNaumann::name, Stokes::name};
}

/// Finds a model. Throws std::invalid_argument with the known names where there is none. A
/// coefficient is ignored by laws that have their own.
inline DragModel drag_model(std::string const& law, std::string const& coefficient,
                            std::string const& formulation) {
  if (formulation != "A" && formulation != "B") {
    throw std::invalid_argument(unknown_name("formulation", formulation, {"A", "B"}));
  }
  Formulation const form = formulation == "A" ? Formulation::A : Formulation::B;
  bool known_law = false;
  for (auto const& entry : drag_laws()) {
    if (law == entry.law) {
      known_law = true;
      if (*entry.coefficient == 0 || coefficient == entry.coefficient) {
        return {law, entry.coefficient, form, entry.kernel};
      }
    }
  }
  throw std::invalid_argument(
      known_law ? unknown_name("drag coefficient", coefficient, drag_coefficient_names())
                : unknown_name("drag law", law, drag_law_names()));
}

/// K [kg/s] of every particle into `drag_kg_s` (1 x n).
inline void drag_coefficients(DragModel const& model, DragInputs const& inputs,
                              Eigen::Ref<Eigen::MatrixXd> drag_kg_s) {
  model.kernel(inputs, model.formulation, drag_kg_s);
}

}  // namespace slidewave
