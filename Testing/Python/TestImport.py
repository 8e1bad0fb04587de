"""Every public class of the module can be imported, and made unless it is abstract."""

import importlib.util
import pathlib
import sys

import vtkcellprojection

root = pathlib.Path(__file__).resolve().parents[2]
folders = {"Sorting": "VTKCELLPROJECTION", "Rendering": "VTKCELLPROJECTION"}
if importlib.util.find_spec("vtkcellprojection.vtkCellProjectionTetGen"):
    folders["Module/TetGen"] = "VTKCELLPROJECTIONTETGEN"
headers = [(h, macro) for folder, macro in folders.items() for h in sorted((root / folder).glob("vtk*.h"))]
public = [h.stem for h, macro in headers if f"class {macro}_EXPORT {h.stem}" in h.read_text()]
missing = [name for name in public if not hasattr(vtkcellprojection, name)]

for name in public:
    if name not in missing:
        try:
            made = getattr(vtkcellprojection, name)()
        except (NotImplementedError, TypeError) as error:
            assert "abstract" in str(error), (name, error)
            print(name, "is abstract")
            continue
        assert made.IsA(name), name

print(len(public), "public classes,", len(missing), "missing:", " ".join(missing))
sys.exit(bool(missing) or not public)
