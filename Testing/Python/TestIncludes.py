"""No file of the libraries leaves an include to the precompiled headers: what it names of them, it includes, or a
header that it includes does. A compiler says the same of a build without precompiled headers, in minutes."""

import functools
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("Rendering", "Rendering/Tiles", "Sorting", "Module/TetGen")
STANDARD = {
    "algorithm": "min|max|minmax|clamp|fill|fill_n|copy|copy_n|copy_if|copy_backward|find|find_if|find_if_not|any_of|all_of|"
                 "none_of|count|count_if|lower_bound|upper_bound|equal_range|equal|reverse|rotate|unique|remove|remove_if|"
                 "transform|for_each|max_element|min_element|minmax_element|nth_element|sort|stable_sort|partial_sort|"
                 "partition|stable_partition|swap_ranges|includes|set_union|set_intersection|set_difference|adjacent_find|"
                 "search|is_sorted|binary_search|merge|inplace_merge|push_heap|pop_heap|make_heap|sort_heap|generate|"
                 "lexicographical_compare|replace",
    "array": "array",
    "cmath": "sqrt|fabs|pow|exp|exp2|expm1|log|log2|log10|log1p|sin|cos|tan|acos|asin|atan|atan2|floor|ceil|round|lround|"
             "llround|trunc|rint|nearbyint|isnan|isfinite|isinf|fma|hypot|cbrt|ldexp|frexp|nextafter|copysign|signbit|fmod|"
             "remainder|ilogb|scalbn|erf|fmin|fmax",
    "functional": "function|less|greater|hash|plus|minus|ref|cref|multiplies|bind",
    "iostream": "cout|cerr",
    "map": "map|multimap",
    "numeric": "accumulate|iota|partial_sum|inner_product|exclusive_scan|inclusive_scan|adjacent_difference|gcd|reduce",
    "string": "string|to_string|stoi|stod|getline",
    "unordered_map": "unordered_map|unordered_multimap",
    "vector": "vector",
}
# What is called on without its class being named.
CHAINS = {
    "vtkPointData": r"GetPointData\(\)\s*->",
    "vtkCellData": r"GetCellData\(\)\s*->",
    "vtkCellArray": r"GetCells\(\)\s*->",
    "vtkRenderWindow": r"(?:GetRenderWindow|GetVTKWindow)\(\)\s*->",
}
COMMENT = re.compile(r"//.*|/\*(?:.|\n)*?\*/")
INCLUDE = re.compile(r"#\s*include\s+[<\"]([^>\"]+)[>\"]")


def needs_class(text, name, is_header):
    if name in CHAINS and re.search(CHAINS[name], text):
        return True
    # A pointer that is handed on, or a member of a header, needs no more than the name.
    for variable in re.findall(rf"\b{name}\s*\*\s*(?:const\s+)?(\w+)", text):
        if re.search(rf"\b{variable}\s*->", text):
            return True
    pattern = rf"\b{name}::" if is_header else rf"\b{name}\b(?!\s*[*&;])"
    return re.search(pattern, text) is not None


class Library:
    def __init__(self, folders):
        paths = [path for folder in FOLDERS for path in (ROOT / folder).iterdir() if path.suffix in (".cxx", ".h")]
        self.texts = {path.name: COMMENT.sub("", path.read_text()) for path in paths}
        self.folders = folders

    @functools.lru_cache(maxsize=None)
    def read_theirs(self, name):
        paths = [folder / name for folder in self.folders if (folder / name).is_file()]
        return paths[0].read_text(errors="ignore") if paths else ""

    def read(self, name):
        return self.texts[name] if name in self.texts else self.read_theirs(name)

    def reach(self, name):
        """What a file includes, by others, too."""
        reached, waiting = {name}, [name]
        while waiting:
            new = set(INCLUDE.findall(self.read(waiting.pop()))) - reached
            reached |= new
            waiting += new
        return reached

    def needs(self, name, header):
        if header in STANDARD:
            return re.search(rf"\bstd::(?:{STANDARD[header]})\b", self.texts[name]) is not None
        return needs_class(self.texts[name], header[:-2], name.endswith(".h"))

    def find_missing(self, name, headers):
        reached = self.reach(name)
        return [f"{name} needs {header}" for header in headers if header not in reached and self.needs(name, header)]


cmake = (ROOT / "Module" / "cmake" / "PrecompiledHeaders.cmake").read_text()
HEADERS = re.findall(r"<([\w/.]+)>", cmake)
assert {"vector", "vtkUnstructuredGrid.h"} <= set(HEADERS), HEADERS
assert all(header in STANDARD or re.fullmatch(r"vtk\w+\.h", header) for header in HEADERS), HEADERS

library = Library([pathlib.Path(folder) for folder in sys.argv[1].split(":")])
assert library.read("vtkMath.h") and len(library.texts) > 200, sys.argv
for text in sorted(library.texts):
    missing = library.find_missing(text, HEADERS)
    assert not missing, missing

# It would see what is missing.
library.texts["PowerCells.cxx"] = INCLUDE.sub("", library.texts["PowerCells.cxx"])
missing = library.find_missing("PowerCells.cxx", HEADERS)
for header in ("algorithm", "vector", "vtkSMPTools.h"):
    assert f"PowerCells.cxx needs {header}" in missing, missing
