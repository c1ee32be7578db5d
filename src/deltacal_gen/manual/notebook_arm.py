# %% [markdown]
# # Notebook: an industrial arm
#
# What the poses can know, the calibration, a check on readings of another day, and a program corrected, cell by cell.

# %%
import numpy as np

import deltacal_gen as dc

dc.manual_examples("examples")
folder = "examples/serial"
result = dc.identify(f"{folder}/robot.toml", f"{folder}/recording.csv")
print(result.headline)

# %% [markdown]
# ```output
# serial/dh: 16 of 28 parameters identified; rms before 2.508 -> after 0.0179 mm,
# held-out 0.02077 mm (noise 0.02, declared)
# ```
#
# ## What no reading sees
#
# A combination that the readings do not tell apart moves no reading: it is named, and the robot file's values hold.

# %%
print(len(result.unidentifiable), "open;", result.unidentifiable[0].text)

# %% [markdown]
# ```output
# 9 open; theta_1 and where the instrument stands are one number in these readings
# ```
#
# ## Another day
#
# Readings of the same machine from another place of the tracker; simulated here with the errors of the truth file.

# %%
poses, truth = f"{folder}/poses.csv", f"{folder}/truth.toml"
dc.simulate(f"{folder}/robot.toml", poses, output="other_day.csv", truth=truth, noise=0.02, seed=8)
validation = dc.validate(result, "other_day.csv")
print(validation.headline)

# %% [markdown]
# ```output
# 60 readings: rms 0.02158 mm, largest 0.0705 mm (noise 0.02 mm)
# ```
#
# The set-up stood elsewhere; it was placed by its own readings, and each error is of a pose left out of that.

# %%
print([(p.setup, p.why, p.unknowns) for p in validation.placed or ()])

# %% [markdown]
# ```output
# [('1', 'elsewhere', 6)]
# ```
#
# ## A program, corrected
#
# An arm's program is joints. Wanted is where the arm as drawn stands at them; the corrected joints bring the real one
# there, position and orientation. By how much each joint changes, in deg:

# %%
program = np.array([[10.0, -20.0, 30.0, 0.0, 40.0, 0.0], [0.0, -10.0, 20.0, 10.0, 30.0, -20.0]])
rows = [",".join(f"q{i}_deg" for i in range(1, 7)), *(",".join(map(str, row)) for row in program)]
with open("program.csv", "w") as file:
    file.write("\n".join(rows) + "\n")
corrected = dc.compensate(result, "program.csv")
print((corrected - program).round(2))

# %% [markdown]
# ```output
# [[-0.06 -0.32 0.42 -0.31 0.06 0.07]
# [-0.07 -0.28 0.43 -0.28 -0.02 -0. ]]
# ```
#
# [An industrial arm](arm.md) has the same in commands, and how to do without an instrument.
