"""Every public class of the module can be imported, and made unless it is abstract."""

import pathlib
import sys

import vtkcellprojection

root = pathlib.Path(__file__).resolve().parents[2]
headers = [h for folder in ("Sorting", "Rendering") for h in sorted((root / folder).glob("vtk*.h"))]
public = [h.stem for h in headers if f"class VTKCELLPROJECTION_EXPORT {h.stem}" in h.read_text()]
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
