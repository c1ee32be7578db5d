# %% [markdown]
# # Notebook: a Delta under a tracker
#
# From the drawing and a morning's readings to commands that know what is wrong with the machine, cell by cell.

# %%
import numpy as np

import deltacal_gen as dc

dc.manual_examples("examples")
robot, recording = "examples/gearbox/robot.toml", "examples/gearbox/recording.csv"

# %% [markdown]
# ## Geometry first
#
# Everything that 150 poses can carry is fitted; what no reading sees is said in words.

# %%
result = dc.identify(robot, recording)
print(result.headline)

# %% [markdown]
# ```output
# delta/42: 15 of 42 parameters identified; rms before 0.2629 -> after 0.06211 mm,
# held-out 0.06851 mm (noise 0.01, declared)
# ```
#
# The table of an answer is a data frame; here the three parameters that are largest beside their uncertainty.

# %%
table = result.to_dataframe()
table["sure"] = table["value"].abs() / table["std"]
print(table.nlargest(3, "sure")[["name", "value", "std", "unit"]].round(2).to_string(index=False))

# %% [markdown]
# ```output
# name  value  std unit
#  l_2   0.61 0.21   mm
# dl_3   1.57 0.58   mm
# dc_1   0.40 0.18   mm
# ```
#
# ## What geometry leaves
#
# Held-out readings are missed by seven times the noise: something is missing.

# %%
diagnosis = dc.diagnose(robot, recording)
print(diagnosis.verdict)
for effect in diagnosis.effects:
    for p in effect.parameters:
        print(f"{effect.name} of limb {p.limb}: {p.name} {p.value:.4f} +- {p.std:.4f} {p.unit}")

# %% [markdown]
# ```output
# missing_physics
# backlash of limb 2: width 0.0502 +- 0.0004 deg
# ```
#
# ## Commands
#
# The play is undone where it acts: a target has another command when it is reached from the other side.

# %%
targets = np.array([[0.0, 0.0, -853.0], [0.0, 0.0, -853.0]])
joints = dc.compensate(diagnosis, targets, channels={"approach2": np.array([1.0, -1.0])})
print(f"{abs(joints[0, 1] - joints[1, 1]):.4f}")

# %% [markdown]
# ```output
# 0.0502
# ```
#
# ## Where to read on
#
# [Find what geometry does not explain](diagnose.md) has the same in commands, [Command the machine](compensate.md)
# the compensator in C and in a servo loop, [Certify it](certificate.md) what goes to a customer.
