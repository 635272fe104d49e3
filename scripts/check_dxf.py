#!/usr/bin/env python3
"""Holds DXF files against a reader in another language: python3 scripts/check_dxf.py FILE.dxf ...

Needs `pip install ezdxf`. Prints layers and entities; exits with 1 where the reader finds anything to mend.
"""

import sys
from collections import Counter

import ezdxf

MILLIMETRES = 4
clean = True
for name in sys.argv[1:]:
    drawing = ezdxf.readfile(name)
    audit = drawing.audit()
    kinds = Counter(f"{entity.dxf.layer}: {entity.dxftype()}" for entity in drawing.modelspace())
    unit = drawing.header.get("$INSUNITS")
    print(f"{name}: {drawing.dxfversion}, unit {unit}, {len(audit.errors)} errors, {len(audit.fixes)} mended")
    for kind, count in sorted(kinds.items()):
        print(f"  {count:5} {kind}")
    for entry in [*audit.errors, *audit.fixes]:
        print(f"  {entry.message}")
    clean &= not audit.errors and not audit.fixes and unit == MILLIMETRES
sys.exit(0 if clean and len(sys.argv) > 1 else 1)
