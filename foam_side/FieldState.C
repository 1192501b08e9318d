#include "FieldState.H"
#include "IOobjectList.H"
#include "directionMixedFvPatchFields.H"
#include "fixedGradientFvPatchFields.H"
#include "labelIOList.H"
#include "mixedFvPatchFields.H"
#include "processorFvPatch.H"

namespace slidewave::foam {

using namespace Foam;

namespace {

// Numbers of a decomposed mesh's cells or faces in the whole one.
std::vector<long> addressing(fvMesh const& mesh, word const& what, label count, label first) {
  std::vector<long> numbers(count);
  if (Pstream::parRun()) {
    labelIOList const list(IOobject(what, mesh.facesInstance(), polyMesh::meshSubDir, mesh,
                                    IOobject::MUST_READ, IOobject::NO_WRITE, false));
    std::copy(list.begin(), list.end(), numbers.begin());
  } else {
    for (label i = 0; i < count; ++i) numbers[i] = i + first;
  }
  return numbers;
}

template <class Type>
double* doubles(UList<Type>& values) {
  return reinterpret_cast<double*>(values.data());
}

void passNumbers(State& state, std::string const& name, std::vector<long> const& mine) {
  if (!state.saving()) return;
  std::vector<double> numbers(mine.begin(), mine.end());
  state.pass(name, numbers);
}

}  // namespace

FieldState::FieldState(State& state, fvMesh const& mesh)
    : state_(state),
      mesh_(mesh),
      cells_(addressing(mesh, "cellProcAddressing", mesh.nCells(), 0)),
      faces_(addressing(mesh, "faceProcAddressing", mesh.nFaces(), 1)) {
  std::vector<long> unsignedFaces(faces_);
  for (long& face : unsignedFaces) face = std::abs(face);
  passNumbers(state, "mesh.cells", cells_);
  passNumbers(state, "mesh.faces", unsignedFaces);
  for (fvPatch const& patch : mesh.boundary()) {
    passNumbers(state, "mesh.patch." + patch.name(), facesOf(patch));
  }
}

std::vector<long> FieldState::facesOf(fvPatch const& patch) const {
  std::vector<long> faces(faces_.begin() + patch.start(),
                          faces_.begin() + patch.start() + patch.size());
  for (long& face : faces) face = std::abs(face);
  return faces;
}

// Takes from all pieces what this rank now has, by number in the whole mesh.
template <class Type>
void FieldState::regroup(std::string const& name, Foam::Field<Type>& values,
                         std::vector<long> const& mine, char const* numbering) const {
  constexpr int width = sizeof(Type) / sizeof(double);
  Numbers place;
  for (std::size_t i = 0; i < mine.size(); ++i) place[mine[i]] = i;
  double* const out = doubles(values);
  for (int piece = 0; piece < state_.pieces(); ++piece) {
    if (!state_.has(numbering, piece)) continue;
    std::vector<double> const numbers = state_.numbers(numbering, piece);
    std::vector<double> const saved = state_.numbers(name, piece);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      auto const found = place.find(static_cast<long>(numbers[k]));
      if (found != place.end()) {
        std::copy_n(&saved[k * width], width, out + found->second * width);
      }
    }
  }
}

template <class Type>
void FieldState::passPatch(std::string const& name, fvPatchField<Type>& patch) {
  std::vector<long> const faces = facesOf(patch.patch());
  std::string const numbering = "mesh.patch." + patch.patch().name();
  auto const one = [&](char const* what, auto& values) {
    std::string const block = name + what;
    if (state_.regrouped()) {
      regroup(block, values, faces, numbering.c_str());
    } else {
      using Value = std::decay_t<decltype(values[0])>;
      state_.pass(block, doubles(values),
                  values.size() * static_cast<long>(sizeof(Value) / sizeof(double)));
    }
  };
  bool const processor = isA<processorFvPatch>(patch.patch());
  if (state_.regrouped() && processor) return;  // evaluated afterwards
  one(".value", static_cast<Foam::Field<Type>&>(patch));
  if (auto* const gradient = dynamic_cast<fixedGradientFvPatchField<Type>*>(&patch)) {
    one(".gradient", gradient->gradient());
  }
  if (auto* const mixed = dynamic_cast<mixedFvPatchField<Type>*>(&patch)) {
    one(".refValue", mixed->refValue());
    one(".refGrad", mixed->refGrad());
    one(".fraction", mixed->valueFraction());
  }
  if (auto* const mixed = dynamic_cast<directionMixedFvPatchField<Type>*>(&patch)) {
    one(".refValue", mixed->refValue());
    one(".refGrad", mixed->refGrad());
    one(".fraction", mixed->valueFraction());
  }
}

template <class Type>
void FieldState::passCells(std::string const& name, Foam::Field<Type>& cells) {
  std::string const block = name + ".cells";
  if (state_.regrouped()) {
    regroup(block, cells, cells_, "mesh.cells");
  } else {
    state_.pass(block, doubles(cells),
                cells.size() * static_cast<long>(sizeof(Type) / sizeof(double)));
  }
}

template void FieldState::passCells(std::string const& name, Foam::Field<vector>& cells);

template <class Type>
void FieldState::passVolume(GeometricField<Type, fvPatchField, volMesh>& field) {
  passCells(field.name(), field.primitiveFieldRef());
  auto& boundary = field.boundaryFieldRef();
  for (fvPatchField<Type>& patch : boundary) {
    passPatch(field.name() + ".patch." + patch.patch().name(), patch);
  }
  if (!state_.regrouped()) return;
  for (fvPatchField<Type>& patch : boundary) {
    if (patch.coupled()) patch.initEvaluate(Pstream::commsTypes::nonBlocking);
  }
  Pstream::waitRequests();
  for (fvPatchField<Type>& patch : boundary) {
    if (patch.coupled()) patch.evaluate(Pstream::commsTypes::nonBlocking);
  }
}

void FieldState::pass(volScalarField& field) {
  passVolume(field);
}
void FieldState::pass(volVectorField& field) {
  passVolume(field);
}

void FieldState::pass(surfaceScalarField& field) {
  scalarField all(mesh_.nFaces(), Zero);  // turned as in the whole mesh
  auto const each = [&](auto const& use) {
    for (label face = 0; face < mesh_.nInternalFaces(); ++face) {
      use(face, field.primitiveFieldRef()[face]);
    }
    for (fvsPatchScalarField& patch : field.boundaryFieldRef()) {
      forAll(patch, i) use(patch.patch().start() + i, patch[i]);
    }
  };
  each([&](label face, scalar& value) { all[face] = faces_[face] < 0 ? -value : value; });
  std::string const block = field.name() + ".faces";
  if (state_.regrouped()) {
    std::vector<long> mine(faces_);
    for (long& face : mine) face = std::abs(face);
    regroup(block, all, mine, "mesh.faces");
  } else {
    state_.pass(block, all.data(), all.size());
  }
  if (state_.saving()) return;
  each([&](label face, scalar& value) { value = faces_[face] < 0 ? -all[face] : all[face]; });
}

}  // namespace slidewave::foam
