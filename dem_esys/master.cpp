#include "master.h"

#include <Python.h>

#include <cstdio>
#include <stdexcept>

namespace slidewave::esys {
namespace {

PyObject* names = nullptr;  // the script's

/// The last Python error in one line.
std::string python_error() {
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  long line = 0;
  for (PyObject* at = trace; at && at != Py_None; at = PyObject_GetAttrString(at, "tb_next")) {
    PyObject* const number = PyObject_GetAttrString(at, "tb_lineno");
    line = number ? PyLong_AsLong(number) : line;
  }
  PyObject* const text = value ? PyObject_Repr(value) : nullptr;
  std::string const words = text ? PyUnicode_AsUTF8(text) : "unknown error";
  return line > 0 ? "line " + std::to_string(line) + ": " + words : words;
}

/// Runs Python text with the script's names. Throws with Python's words.
void run_text(std::string const& text) {
  if (!PyRun_String(text.c_str(), Py_file_input, names, names)) {
    throw std::runtime_error("ESyS-Particle: " + python_error());
  }
}

}  // namespace

Master::Master(std::filesystem::path const& script,
               std::map<std::string, std::string> const& parameters) {
  PyConfig config;
  PyConfig_InitPythonConfig(&config);
  // Debian's interpreter, whatever comes first in PATH: its site has esys.lsm.
  PyConfig_SetString(&config, &config.program_name, L"/usr/bin/python3");
  config.install_signal_handlers = 0;
  if (PyStatus_Exception(Py_InitializeFromConfig(&config))) {
    throw std::runtime_error("Python does not start");
  }
  names = PyModule_GetDict(PyImport_AddModule("__main__"));
  for (auto const& [name, value] : parameters) {
    char* end = nullptr;
    double const number = std::strtod(value.c_str(), &end);
    PyObject* const object = *end == '\0' && end != value.c_str()
                                 ? PyFloat_FromDouble(number)
                                 : PyUnicode_FromString(value.c_str());
    PyDict_SetItemString(names, ("v_" + name).c_str(), object);
  }
  FILE* const file = std::fopen(script.c_str(), "r");
  if (!PyRun_FileEx(file, script.c_str(), Py_file_input, names, names, 1)) {
    throw InputError(script.string(), "Python", "", python_error());
  }
  if (!PyDict_GetItemString(names, "sim")) {
    throw InputError(script.string(), "sim", "missing", "name the simulation sim = LsmMpi(...)");
  }
  PyObject* const done =
      PyObject_CallMethod(PyDict_GetItemString(names, "sim"), "getTimeStep", nullptr);
  if (done && PyLong_AsLong(done) > 0) {
    throw InputError(
        script.string(), "sim.run()", std::to_string(PyLong_AsLong(done)) + " steps",
        "remove it: the script may only set the scene up, the coupled run advances time");
  }
}

void Master::run(long steps, double dt_s) {
  char text[160];
  std::snprintf(text, sizeof(text),
                "sim.setTimeStepSize(%.17g)\nfor _ in range(%ld): sim.runTimeStep()\n", dt_s,
                steps);
  run_text(text);
}

}  // namespace slidewave::esys
