# %% [markdown]
# # Notebook: a delta printer
#
# From what Klipper keeps to new lines for its configuration, and which distance to print first, cell by cell.

# %%
import deltacal_gen as dc

dc.manual_examples("examples")
found = dc.import_klipper("examples/linear_delta/printer.cfg", "mine")
print(*(f"{name}: {r.n_rows} rows" for name, r in found.recordings.items()), sep="\n")

# %% [markdown]
# ```output
# recording: 31 rows
# mesh_default: 29 rows
# ```
#
# The recording holds probed heights and the distances that were measured on a printed object.

# %%
result = dc.identify("mine/robot.toml", "mine/recording.csv")
print(result.headline)

# %% [markdown]
# ```output
# linear_delta/9: 9 of 9 parameters identified; rms before 0.3413 -> after 0.0167 mm,
# held-out 0.04065 mm (noise 0.0163, residual)
# ```
#
# ## Back to the firmware
#
# The lines are the firmware's own numbers: each as it is and as it is to be, and what either leave on the bed.

# %%
lines = dc.export_compensator(result, export="klipper", output="lines.cfg")
assert lines is not None  # as of every firmware
print(f"bed: {lines.before.bed_rms_mm:.3f} -> {lines.after.bed_rms_mm:.3f} mm rms")
print(f"sideways: {lines.before.lateral_rms_mm:.3f} -> {lines.after.lateral_rms_mm:.3f} mm rms")

# %% [markdown]
# ```output
# bed: 0.278 -> 0.000 mm rms
# sideways: 1.436 -> 0.000 mm rms
# ```
#
# ## What heights alone leave open
#
# A mesh says whether the bed comes out flat, not whether 100 mm comes out as 100 mm: the answer says which distance to
# print, and how far it is open now.

# %%
mesh = dc.identify("mine/robot.toml", "mine/mesh_default.csv")
print(mesh.next_measurements[0].measurement)

# %% [markdown]
# ```output
# print two marks 155 mm apart through the centre, 60 deg from x, and measure their distance: these readings leave
# it open by 0.59 mm, with a bed as flat (arm_3 +1.2 mm, arm_1 +1.2 mm, arm_2 +1.2 mm, radius_2 +1 mm)
# ```
#
# [A delta printer](printer.md) has the same in commands, and what else can be wrong with such a machine.
