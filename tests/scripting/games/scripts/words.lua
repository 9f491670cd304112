print(table.concat({ ... }, " "))
