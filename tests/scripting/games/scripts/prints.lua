print("first", 1)
print("second")
error("third")
